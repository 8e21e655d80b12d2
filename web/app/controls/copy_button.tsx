/** A button that copies a text and briefly confirms it. */

import { signal } from '@preact/signals';
import { useId } from 'preact/hooks';
import { complain } from '../state/running';
import { say } from '../language/say';

const COPIED_MILLISECONDS = 2000;

/** The button that currently confirms a copy; null for none. */
const copied = signal<string | null>(null);
let timer: ReturnType<typeof setTimeout> | undefined;

interface CopyButtonProps {
  /** on the button */
  text: string;
  /** its accessible name if its text is not enough; in the language of the page */
  name?: string;
  title?: string;
  class?: string;
  disabled?: boolean;
  /** the text that is copied */
  write(): string;
  /** called with the copied text */
  onCopied?(written: string): void;
}

export function CopyButton({ text, name, write, onCopied, ...attributes }: CopyButtonProps) {
  const id = useId();
  const isCopied = copied.value === id;
  const copy = async () => {
    const written = write();
    await navigator.clipboard.writeText(written);
    tellCopied(id);
    onCopied?.(written);
  };
  return (
    <button
      type="button"
      {...attributes}
      aria-label={isCopied ? undefined : name}
      onClick={() => void copy().catch(complain)}
    >
      {isCopied ? say('Copied') : text}
    </button>
  );
}

function tellCopied(id: string): void {
  clearTimeout(timer);
  copied.value = id;
  timer = setTimeout(() => (copied.value = null), COPIED_MILLISECONDS);
}
