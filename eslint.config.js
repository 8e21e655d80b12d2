import tseslint from 'typescript-eslint';

export default tseslint.config(
  { ignores: ['build', 'dist', '.toolchain', 'public', 'node_modules'] },
  ...tseslint.configs.recommended,
  {
    rules: {
      'max-lines-per-function': ['error', { max: 60, skipBlankLines: true, skipComments: true }],
      'max-params': ['error', 5],
      eqeqeq: 'error',
      'prefer-const': 'error',
      'no-console': 'error',
      '@typescript-eslint/no-unused-vars': ['error', { argsIgnorePattern: '^_' }],
    },
  },
  // The titles of suites are the functions there; scripts and the command line speak to a terminal.
  { files: ['tests/**'], rules: { 'max-lines-per-function': 'off' } },
  {
    files: ['scripts/**', 'web/cli/**', 'tests/bench/**', 'tests/library/fixtures/**'],
    rules: { 'no-console': 'off' },
  },
);
