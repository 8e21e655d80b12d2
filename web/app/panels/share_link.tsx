/** The button that copies a link with all settings. */

import { useState } from 'preact/hooks';
import { count } from '../controls/numbers';
import { samples } from '../files/samples';
import { complain } from '../state/running';
import { linkOfWants } from '../state/saved_session';
import { results, status } from '../state/store';
import { say } from '../language/say';

const COPIED_MILLISECONDS = 2000;
/** Some programs cut links that are longer than this. */
const LONG_LINK = 8000;

export function ShareLink() {
  const [isCopied, setCopied] = useState(false);
  const copy = async () => {
    const link = shareLink();
    await navigator.clipboard.writeText(link);
    setCopied(true);
    setTimeout(() => setCopied(false), COPIED_MILLISECONDS);
    if (link.length > LONG_LINK)
      status.notice.value = {
        kind: 'info',
        text: say(
          'The link has {count} characters, as it contains what was painted or pinned: some programs cut it.',
          { count: count(link.length) },
        ),
      };
  };
  return (
    <button
      type="button"
      class="quiet"
      disabled={!results.file.value}
      title={say('Copy a link with all settings; the file itself stays here')}
      onClick={() => void copy().catch(complain)}
    >
      {isCopied ? say('Copied') : say('Share link')}
    </button>
  );
}

/** Carries all settings, and names the file. */
function shareLink(): string {
  const file = results.file.value!.name;
  const sample = samples.value.find((one) => one.file === file);
  const query = sample ? `?sample=${sample.id}` : '';
  return `${location.origin}${location.pathname}${query}#${linkOfWants(file)}`;
}
