/** What is being computed: tasks of the page and phases of the core. */

import type { MessageTable } from '../message_table';

export const PROGRESS: MessageTable = {
  Opening: 'ファイルを開いています',
  'Reading the mesh': 'メッシュを読み込み中',
  'Reading the materials': 'マテリアルを読み込み中',
  'Finding pins': '固定点を検索中',
  'Finding modes': '固有モードを計算中',
  'Measuring strain': 'ひずみを測定中',
  'Measuring curvature': '曲率を測定中',
  'Collapsing edges': '辺を縮約中',
  'Sharing the faces out': '面数を配分中',
  'Fitting the result': '結果をフィット中',
  'Tuning the result to its solver': '結果をソルバー向けに調整中',
  'Measuring the result': '結果を測定中',
  'Writing and checking the file': 'ファイルを書き出して検証中',
  'Dressing the result in its materials': '結果にマテリアルを適用中',
  'Asking why vertices stay': '頂点が残る理由を調査中',
  'Marking the deviation': 'ずれの目盛りを作成中',
  'welding vertices': '頂点を結合中',
  'assembling matrices': '行列を構築中',
  factorising: '行列を分解中',
  'solving for modes': 'モードを計算中',
  'measuring strain': 'ひずみを測定中',
  'measuring curvature': '曲率を測定中',
  'collapsing edges': '辺を縮約中',
  'measuring distance': '距離を測定中',
  'comparing modes': 'モードを比較中',
  fitting: 'フィット中',
  simulating: 'シミュレーション中',
  'looking for symmetry': '対称性を検出中',
};
