/** The button over the stage that opens the panel of pictures. */

import { pictures } from './pictures_state';
import './pictures.css';
import { say } from '../../language/say';

export function PicturesButton() {
  return (
    <button
      type="button"
      class="pictures-button"
      aria-label={say('Pictures')}
      aria-expanded={pictures.isOpen.value}
      title={say('Save pictures, videos and figures')}
      onClick={() => (pictures.isOpen.value = !pictures.isOpen.value)}
    >
      <svg width="18" height="18" viewBox="0 0 18 18" aria-hidden="true">
        <path
          d="M2 5.5h3l1.2-2h5.6l1.2 2h3v9H2zM9 12.5a2.7 2.7 0 1 0 0-5.4 2.7 2.7 0 0 0 0 5.4z"
          fill="none"
          stroke="currentColor"
          stroke-width="1.3"
          stroke-linejoin="round"
        />
      </svg>
    </button>
  );
}
