// The contents of the site: its documents in the order of its side bar, and the results of its gallery.

export const SECTIONS = [
  {
    name: 'Use it',
    pages: [
      ['README.md', 'Guide'],
      ['docs/engines.md', 'In your engine'],
      ['docs/engines/README.md', 'Engine loaders'],
      ['docs/formats.md', 'Formats'],
      ['docs/report.md', 'Reports'],
      ['docs/library.md', 'Library'],
      ['docs/batch.md', 'Batches'],
      ['docs/scale.md', 'Many machines'],
      ['docs/recipes/README.md', 'Recipes'],
      ['docs/hosting.md', 'Hosting'],
    ],
  },
  {
    name: 'How well it works',
    pages: [
      ['docs/evidence.md', 'Evidence'],
      ['docs/results.md', 'Results'],
      ['docs/motions.md', 'Motions in engines'],
      ['docs/validation.md', 'Validation'],
      ['docs/benchmarks.md', 'Benchmarks'],
      ['docs/pictures.md', 'Pictures'],
      ['docs/reliability.md', 'Reliability'],
    ],
  },
  {
    name: 'How it works',
    pages: [
      ['docs/paper.md', 'The paper'],
      ['docs/modes.md', 'Modes'],
      ['docs/engine-models.md', 'Engine models'],
      ['docs/simplification.md', 'Simplification'],
      ['docs/simulation.md', 'Simulation'],
      ['docs/experiments.md', 'Experiments'],
      ['docs/architecture.md', 'Architecture'],
      ['docs/glossary.md', 'Glossary'],
    ],
  },
  {
    name: 'About',
    pages: [
      ['CHANGELOG.md', 'Changes'],
      ['CONTRIBUTING.md', 'Contributing'],
      ['SECURITY.md', 'Security'],
      ['THIRD_PARTY.md', 'Third-party software'],
    ],
  },
];

/** Files and folders of the repository that are published with the documents. */
export const PUBLISHED = ['LICENSE', 'docs'];

/** `optimize`, `simulate`: the arguments after the file names on the command line. */
export const GALLERY = [
  { sample: 'organic', optimize: ['--ratio', '0.25'], simulate: ['--scenario', 'sway', '--substeps', '40'] },
  { sample: 'cloth', optimize: ['--ratio', '0.25'], simulate: ['--scenario', 'hang', '--substeps', '40'] },
  { sample: 'tower', optimize: ['--ratio', '0.5'], simulate: ['--scenario', 'sway', '--substeps', '40'] },
  { sample: 'bar', optimize: ['--ratio', '0.25'], simulate: ['--scenario', 'twist', '--substeps', '40'] },
];
