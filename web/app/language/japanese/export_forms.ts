/** The texts of the export panel on formats, presets and levels. */

import type { MessageTable } from '../message_table';

export const EXPORT_FORMS: MessageTable = {
  'Simulated as': 'シミュレーション方式',
  Seams: 'シーム',
  'like-input': 'ファイルと同じ',
  on: 'オン',
  off: 'オフ',
  Format: 'フォーマット',
  'glTF and its files, zipped': 'glTF と付属ファイル (ZIP)',
  'OBJ and materials, zipped': 'OBJ とマテリアル (ZIP)',
  'Save {ending}': '{ending} を保存',
  'Drag it onto a folder, or into a program that takes files':
    'フォルダーや、ファイルを受け取れるアプリケーションにドラッグしてください',
  'drag it out': 'ドラッグして取り出す',
  'Vertices are stored as they came.': '頂点は元のファイルと同じ形式で保存されます。',
  'Every program reads it.': 'どのソフトウェアでも読み込めます。',
  'About half the size; most engines draw it without decoding (KHR_mesh_quantization).':
    'サイズは約半分です。ほとんどのエンジンがそのまま描画できます (KHR_mesh_quantization)。',
  'Small and quick to open in three.js, Babylon.js and PlayCanvas (EXT_meshopt_compression).':
    '小さく、three.js、Babylon.js、PlayCanvas ですばやく開けます (EXT_meshopt_compression)。',
  'The smallest, slower to open; most web viewers read it (KHR_draco_mesh_compression).':
    '最も小さく、開くのは遅くなります。ほとんどの Web ビューアーが対応しています (KHR_draco_mesh_compression)。',
  'How GLB and glTF store vertices: like-input (as IN does), none, quantized (KHR_mesh_quantization), meshopt (EXT_meshopt_compression) or draco (KHR_draco_mesh_compression). The last three round values that the input stores as floats.':
    'GLB と glTF の頂点の保存形式です。like-input (入力と同じ)、none (なし)、quantized (KHR_mesh_quantization)、meshopt (EXT_meshopt_compression)、draco (KHR_draco_mesh_compression)。最後の 3 つは入力の浮動小数点数を丸めます。',
  'Not run: it reads only GLB and glTF.': '検証の対象外です (GLB と glTF のみ検証できます)。',
  'Levels of detail': '詳細度 (LOD)',
  'Levels go into': 'LOD の保存先',
  'Where further levels go: files (of their own, with _lod1 and so on at the end of their names), msft (into the file of the result, by MSFT_lod), nodes (into it as nodes NAME_LOD0, NAME_LOD1 and so on, all shown at once by a viewer that does not know these names).':
    '追加の LOD の保存先です。files (名前の末尾が _lod1 などの別ファイル)、msft (MSFT_lod として結果のファイルの中)、nodes (NAME_LOD0、NAME_LOD1 などのノードとして同じファイルの中。名前を解釈しないビューアーではすべて表示されます)。',
  'separate files': '個別のファイル',
  'nodes NAME_LOD0, _LOD1 ...': 'ノード NAME_LOD0、_LOD1 ...',
  'One additional file for each level: NAME_lod1 and so on.':
    'レベルごとに NAME_lod1 などのファイルを追加します。',
  'Unity and Unreal make a level group of nodes with these names; other viewers show all of them at once.':
    'Unity と Unreal はこの名前から LOD グループを作ります。他のビューアーではすべて同時に表示されます。',
  'Babylon.js switches levels by the size on the screen; viewers that do not support this show the first level.':
    'Babylon.js は画面上の大きさでレベルを切り替えます。非対応のビューアーでは最初のレベルが表示されます。',
  'Shares of the faces or numbers of faces, separated by commas':
    '面の割合または面数をコンマ区切りで指定します',
  '“{word}” is not a level: give shares such as 25 % or 0.25, or numbers of up to {faces} faces.':
    '「{word}」はレベルではありません。25 % や 0.25 のような割合、または {faces} 以下の面数を指定してください。',
  'Add a level': 'レベルを追加',
  'Remove the last': '最後のレベルを削除',
  'See where they change': '切り替わる位置を見る',
  'Shows each level at the size on the screen at which it takes over':
    '各レベルを、切り替わるときの画面上の大きさで表示します',
  'Writing the levels ...': 'レベルを書き出しています...',
  'Drawing the levels': 'レベルを描画しています',
  'LOD{number}, {faces} faces, {height} pixels high': 'LOD{number}、{faces} 面、高さ {height} ピクセル',
  '{faces} faces': '{faces} 面',
  Distance: '距離',
  'Moves the model away; the level changes where its error is one pixel':
    'モデルを遠ざけます。誤差が 1 ピクセルになる位置でレベルが切り替わります',
  '{pixels} px across': '幅 {pixels} px',
  'Draw it large': '拡大して表示',
  'Enlarges the level of this distance to the whole picture': 'この距離でのレベルを画面いっぱいに表示します',
  'Where levels change': 'レベルの切り替え位置',
  nearest: '最も近い',
  'never: the next level has the same error': '使われません (次のレベルと誤差が同じです)',
  'below {pixels} px': '{pixels} px 未満',
  'Made for': '用途',
  Preset: 'プリセット',
  choose: '選択',
  'All of these are set.': 'すべて設定済みです。',
  'Use these settings': 'この設定を使う',
  Web: 'Web',
  'A small download: meshopt compresses vertices, and three.js, Babylon.js and model-viewer decode them quickly.':
    'ダウンロードが小さくなります。meshopt で頂点を圧縮し、three.js、Babylon.js、model-viewer がすばやく展開します。',
  Mobile: 'モバイル',
  'Vertices take half the memory and need no decoding, and two further levels are used where the model is small on the screen.':
    '頂点のメモリは半分で、展開は不要です。画面上で小さく見えるときは 2 つの追加レベルに切り替わります。',
  Cloth: '布',
  'A sheet without volume: its borders stay where they are, and after the collapses vertices are moved until it vibrates at the frequencies of the original.':
    '中身のないシートです。縁は元の位置に保たれ、縮約のあと、元と同じ周波数で折れ曲がるように頂点を動かします。',
  'Soft body': 'ソフトボディ',
  'A closed body with volume: faces are kept where its volume bends, and collapses stop before an angle falls below 10 degrees, because thin triangles make soft bodies stiff and unstable.':
    '中身のある閉じた物体です。体積が曲がる部分の面を残し、角度が 10 度を下回る前に縮約を止めます。細い三角形はソフトボディを硬く不安定にするためです。',
  '3D print': '3D プリント',
  'The surface stays within 0.1 % of its size (0.1 mm of 10 cm), edges above 30 degrees stay sharp, and texture seams, which do not matter in print, do not limit collapses.':
    '表面のずれを大きさの 0.1 % (10 cm で 0.1 mm) 以内に抑え、30 度を超える辺は鋭いまま保ちます。印刷に影響しないテクスチャのシームは制約になりません。',
};
