/** The choice of the language: each language by its own name. */

import { chooseLanguage, shown } from '../language/language';
import type { Language } from '../language/language';
import { say } from '../language/say';
import { complain } from '../state/running';
import './language_choice.css';

const LANGUAGES: { language: Language; name: string }[] = [
  { language: 'en', name: 'EN' },
  { language: 'ja', name: '日本語' },
];

export function LanguageChoice() {
  return (
    <div class="choice language" role="group" aria-label={say('Language')}>
      {LANGUAGES.map(({ language, name }) => (
        <button
          key={language}
          type="button"
          lang={language}
          aria-pressed={shown.value.language === language}
          onClick={() => void chooseLanguage(language).catch(complain)}
        >
          {name}
        </button>
      ))}
    </div>
  );
}
