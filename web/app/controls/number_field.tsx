/** A field for a number. While the user types, arriving results do not replace the text, until it is entered or the field is left. */

import type { InputHTMLAttributes } from 'preact';
import { useState } from 'preact/hooks';

interface NumberFieldProps extends Pick<
  InputHTMLAttributes,
  'id' | 'aria-label' | 'aria-labelledby' | 'min' | 'max' | 'step' | 'title' | 'placeholder'
> {
  /** null: the placeholder is shown */
  value: number | null;
  /** NaN if the text is not a number */
  onEnter(value: number): void;
}

export function NumberField({ value, onEnter, ...attributes }: NumberFieldProps) {
  const [typed, setTyped] = useState<string | null>(null);
  return (
    <input
      type="number"
      {...attributes}
      value={typed ?? value ?? ''}
      onInput={(event) => setTyped(event.currentTarget.value)}
      onChange={(event) => {
        setTyped(null);
        onEnter(event.currentTarget.valueAsNumber);
      }}
      onBlur={() => setTyped(null)}
    />
  );
}
