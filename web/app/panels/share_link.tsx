/** The button that copies a link with all settings. */

import { CopyButton } from '../controls/copy_button';
import { count } from '../controls/numbers';
import { samples } from '../files/samples';
import { linkOfWants } from '../state/saved_session';
import { results, status } from '../state/store';
import { say } from '../language/say';

/** Some programs truncate longer links. */
const LONG_LINK = 8000;

export function ShareLink() {
  return (
    <CopyButton
      text={say('Share link')}
      title={say('Copy a link with all settings; the file itself stays here')}
      class="quiet"
      disabled={!results.file.value}
      write={shareLink}
      onCopied={warnOfLength}
    />
  );
}

function warnOfLength({ length }: string): void {
  if (length <= LONG_LINK) return;
  status.notice.value = {
    kind: 'info',
    text: say(
      'The link has {count} characters because it contains what was painted or pinned: some programs cut it off.',
      { count: count(length) },
    ),
  };
}

/** The link contains all settings and the name of the file. */
function shareLink(): string {
  const file = results.file.value!.name;
  const sample = samples.value.find((one) => one.file === file);
  const query = sample ? `?sample=${sample.id}` : '';
  return `${location.origin}${location.pathname}${query}#${linkOfWants(file)}`;
}
