/**
 * Sentences and clauses that the engine writes in English, by their form: `sentence` finds them when they are shown. A
 * sentence without an entry here is shown in English.
 */

import type { MessageTable } from '../message_table';

export const ENGINE: MessageTable = {
  // web/engine/body/health.ts
  '{count} seam vertex welded': 'シームの頂点 {count} 個を結合',
  '{count} seam vertices welded': 'シームの頂点 {count} 個を結合',
  '{count} face with a repeated vertex set aside': '頂点が重複する面 {count} 個を除外',
  '{count} faces with a repeated vertex set aside': '頂点が重複する面 {count} 個を除外',
  '{count} duplicate face set aside': '重複する面 {count} 個を除外',
  '{count} duplicate faces set aside': '重複する面 {count} 個を除外',
  '{count} face turned to agree with its neighbours': '隣に合わせて面 {count} 個の向きを修正',
  '{count} faces turned to agree with their neighbours': '隣に合わせて面 {count} 個の向きを修正',
  '{count} edge shared by more than two faces, locked': '3 面以上が共有する辺 {count} 本をロック',
  '{count} edges shared by more than two faces, locked': '3 面以上が共有する辺 {count} 本をロック',
  '{count} vertex where surfaces only touch, locked': '面が点で接する頂点 {count} 個をロック',
  '{count} vertices where surfaces only touch, locked': '面が点で接する頂点 {count} 個をロック',
  '{count} edge between faces of opposite orientation': '向きが逆の面に挟まれた辺 {count} 本',
  '{count} edges between faces of opposite orientation': '向きが逆の面に挟まれた辺 {count} 本',
  '{count} open border': '開いた境界 {count} か所',
  '{count} open borders': '開いた境界 {count} か所',
  'the largest residual of the modes is {residual}: with needle triangles their last digits are rounding errors':
    'モードの最大残差は {residual} です。細長い三角形のため、末尾の桁は丸め誤差を含みます',
  'the largest residual of the modes is {residual}: with needle triangles {count} mode consists of rounding errors':
    'モードの最大残差は {residual} です。細長い三角形のため、モード {count} 個は丸め誤差にすぎません',
  'the largest residual of the modes is {residual}: with needle triangles {count} modes consist of rounding errors':
    'モードの最大残差は {residual} です。細長い三角形のため、モード {count} 個は丸め誤差にすぎません',
  // web/engine/core/mode_set.ts
  '{count} solid part': 'ソリッド {count} 個',
  '{count} solid parts': 'ソリッド {count} 個',
  '{count} cavity': '空洞 {count} 個',
  '{count} cavities': '空洞 {count} 個',
  '{count} shell': 'シェル {count} 個',
  '{count} shells': 'シェル {count} 個',
  '{count} Laplacian part': 'ラプラシアン {count} 個',
  '{count} Laplacian parts': 'ラプラシアン {count} 個',
  '{first} to {last}': '{first}〜{last}',
  // web/engine/report/hot_spots.ts
  'Modes {first} and {second} strain different places ({common} % in common): {end}.':
    'モード {first} と {second} は異なる場所をひずませます (共通 {common} %)。{end}。',
  'faces stay at both': '両方の場所に面を残します',
  '1 other pair does, too, and faces stay at all of them': 'ほかに 1 組あり、そのすべてに面を残します',
  '{count} other pairs do, too, and faces stay at all of them':
    'ほかに {count} 組あり、そのすべてに面を残します',
  // web/engine/report/stop_report.ts
  'no edge is left that could collapse': '縮約できる辺が残っていません',
  'of the remaining edges {share} would change the topology': '残りの辺のうち {share} はトポロジーが変わる',
  '{share} flip a face': '{share} は面が裏返る',
  '{share} break a seam, a border or a lock': '{share} はシーム・境界・ロックを壊す',
  '{share} make an angle too small': '{share} は角が小さくなりすぎる',
  '{share} move too far from the surface': '{share} は表面から離れすぎる',
  // web/engine/report/explanation.ts
  'the surface would move': '表面が動く',
  'it bends here': 'ここで曲がる',
  'it is curved here': 'ここは湾曲している',
  'triangles would get thinner': '三角形が細くなる',
  'triangles would get larger': '三角形が大きくなる',
  '{share} % of the vertices are removed before it.': '頂点の {share} % がこれより先に取り除かれます。',
  'It cannot be removed: {why}.': '取り除けません: {why}。',
  'a lock, a border or a pin holds it': 'ロック、境界、または固定されています',
  'the topology would change': 'トポロジーが変わります',
  'a face would flip': '面が裏返ります',
  'an angle would get too small': '角が小さくなりすぎます',
  'the surface would move too far': '表面が離れすぎます',
  // web/engine/motion/convergence.ts
  'At {count} substep the deviation of {judged} is not reliable, because {finer} would move the original itself by {moved}: {take}.':
    'サブステップ {count} では、ずれ {judged} は信頼できません。{finer} にすると元のメッシュの動きだけで {moved} 変わります。{take}。',
  'At {count} substeps the deviation of {judged} is not reliable, because {finer} would move the original itself by {moved}: {take}.':
    'サブステップ {count} では、ずれ {judged} は信頼できません。{finer} にすると元のメッシュの動きだけで {moved} 変わります。{take}。',
  // web/engine/report/level_words.ts
  '{file}: a further level has {count} faces, more than the {number} of the result: give “{name}” smaller shares of the original.':
    '{file}: 追加の LOD は {count} 面で、結果の {number} 面より多くなっています。「{name}」には元のメッシュに対するより小さい割合を指定してください。',
  // web/engine/report/solver_report.ts
  "In {solver} the first ten frequencies are off by {tuned} tuned, by {untouched} with the original's numbers.":
    '{solver} での最初の 10 個の周波数の誤差は、調整後 {tuned}、元の数値のままでは {untouched} です。',
  "In {solver} the first ten frequencies are off by {tuned} tuned ({unseen} in modes that were not tuned), by {untouched} with the original's numbers.":
    '{solver} での最初の 10 個の周波数の誤差は、調整後 {tuned} (調整に使わなかったモードでは {unseen})、元の数値のままでは {untouched} です。',
  'In {solver} this shape bends without resistance, so there are no frequencies to tune: only masses are tuned, and the factors stay at 1.':
    '{solver} ではこの形は抵抗なく曲がるため、調整する周波数がありません。質量だけを調整し、係数は 1 のままです。',
  'In {solver} this shape has no modes because of triangles without area, so there are no frequencies to tune: only masses are tuned, and the factors stay at 1.':
    '{solver} では面積のない三角形があるためこの形のモードが求まらず、調整する周波数がありません。質量だけを調整し、係数は 1 のままです。',
  'In {solver} the modes of this shape do not converge, so there are no frequencies to tune: only masses are tuned, and the factors stay at 1.':
    '{solver} ではこの形のモードの計算が収束しないため、調整する周波数がありません。質量だけを調整し、係数は 1 のままです。',
  "A tuned stiffness would take the frequencies farther away on average, so the file keeps the original's and transfers its masses.":
    '剛性を変えると周波数は平均してさらに離れるため、ファイルは元の剛性を保ち、質量だけを移します。',
  '{solver} can blow up with a {name} of {value}: keep it below {max}, which is half of mass times quality.':
    '{solver} は {name} が {value} だと発散することがあります。{max} (mass × quality の半分) より小さくしてください。',
  '{solver} takes a {name} of at most {max}, and this needs {value}: choose another material or thickness, or give your own numbers.':
    '{solver} の {name} は {max} までですが、{value} が必要です。別の材質か厚さを選ぶか、数値を直接指定してください。',
  '{solver} takes a {name} of at least {min}, and this needs {value}: choose another material or thickness, or give your own numbers.':
    '{solver} の {name} は {min} 以上ですが、{value} が必要です。別の材質か厚さを選ぶか、数値を直接指定してください。',
  'The motion itself was not tested.': '動き自体は調べていません。',
  "{scene} it deviates from the original by {tuned} of its size tuned, by {untouched} with the original's stiffness and masses (noise {noise}).":
    '{scene}とき、元からのずれは大きさの {tuned} (調整後)、{untouched} (元の剛性と質量) です (ノイズ {noise})。',
  "{scene} it deviates from the original by {tuned} of its size tuned, by {untouched} with the original's stiffness and masses (noise {noise}), so the file keeps the original's stiffness and transfers its masses.":
    '{scene}とき、元からのずれは大きさの {tuned} (調整後)、{untouched} (元の剛性と質量) です (ノイズ {noise})。そのため、ファイルには元の剛性と質量を記録します。',
  'When it sways,': '揺れる',
  'When it hangs,': '垂れ下がる',
  'When it sways and hangs,': '揺れて垂れ下がる',
  // web/engine/stages/fit.ts and web/engine/report/fit_words.ts
  'the fit would break a limit of deviation or angle': 'フィットするとずれか角の制限を超えます',
  // web/app/worker, web/engine/document
  'No file is open: open one first.': 'ファイルが開かれていません。先にファイルを開いてください。',
  // web/engine/document/dropped.ts
  'extension {name}': '拡張機能 {name}',
  // web/engine/settings/check.ts and kinds.ts
  'This is {value}: give {allowed} (default: {usual}).':
    '「{value}」は使えません。{allowed}を指定してください (既定値: {usual})。',
  'an empty list': '空のリスト',
  'numbers from {least} to {most} separated by commas': '{least} から {most} までの数値 (コンマ区切り)',
  'a number from {least} to {most}': '{least} から {most} までの数値',
  'a whole number from {least} to {most}': '{least} から {most} までの整数',
  // web/engine/report/settings_reader.ts
  '{name} {problem}: save it again with “Save settings”.':
    '{name} は使えない設定ファイルです ({problem})。「設定を保存」で保存し直してください。',
  'is not JSON': 'JSON 形式ではありません',
  'is not a {schema}': '{schema} ではありません',
  'is for "{solver}", which is not one of {known}': '「{solver}」用ですが、対応しているのは {known} です',
  'names none of the solvers {known}': 'ソルバー {known} のいずれも指定されていません',
  'has {problem} for {body}': '{body}: {problem}',
  'a body without a name': '名前のない物体',
  'triangles that refer to vertices it does not have': '三角形が存在しない頂点を参照しています',
  'render vertices that refer to vertices it does not have': '描画用の頂点が存在しない頂点を参照しています',
  'masses that are not one number above 0 for each vertex': '各頂点に 0 より大きい質量がありません',
  'factors that are not two numbers above 0 for each vertex': '各頂点に 0 より大きい係数が 2 つありません',
  'damaged stretching constraints': '伸びの拘束が壊れています',
  'damaged bending constraints': '曲げの拘束が壊れています',
  'pins that refer to vertices it does not have': '固定が存在しない頂点を参照しています',
  'no mesh, mass, stretch or bend': 'メッシュ、質量、伸び、曲げのいずれかがありません',
  'damaged positions': '位置が壊れています',
  // web/app/viewer/picture
  'The GIF could not be made: {why}.': 'GIF を作成できませんでした ({why})。',
  'This browser cannot encode a video of {width} x {height} pixels: use a current Chrome, Edge, Firefox or Safari, or a smaller size.':
    'このブラウザーでは {width} x {height} ピクセルの動画を作成できません。最新の Chrome、Edge、Firefox、Safari を使うか、サイズを小さくしてください。',
  'The graphics card draws at most {width} x {height} pixels: choose a smaller picture.':
    'このグラフィックスカードで描画できるのは {width} x {height} ピクセルまでです。小さいサイズを選んでください。',
};
