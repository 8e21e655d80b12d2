/** Text for screen readers, spoken once it has stayed the same for a while. */

import { useEffect, useState } from 'preact/hooks';

const SETTLED_MILLISECONDS = 1000;

export function Spoken({ text }: { text: string }) {
  const [said, setSaid] = useState('');
  useEffect(() => {
    const timer = setTimeout(() => setSaid(text), SETTLED_MILLISECONDS);
    return () => clearTimeout(timer);
  }, [text]);
  return (
    <p class="spoken" role="status">
      {said}
    </p>
  );
}
