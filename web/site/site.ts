/** What every page of the site loads: its styles and its font. */

import '@fontsource-variable/inter/wght.css';
import './site.css';
