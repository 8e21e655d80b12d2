/** A field for a number. What is being typed stays while results arrive, until it is entered or left. */

import type { InputHTMLAttributes } from 'preact';
import { useState } from 'preact/hooks';

interface NumberFieldProps extends Pick<
  InputHTMLAttributes,
  'id' | 'aria-label' | 'aria-labelledby' | 'min' | 'max' | 'step' | 'title' | 'placeholder'
> {
  /** null: none is shown, but the placeholder */
  value: number | null;
  /** NaN where what was entered is no number */
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
