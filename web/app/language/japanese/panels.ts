/** The comparison of methods, pictures, the queue, the explanations of settings, and notes on files and modes. */

import type { MessageTable } from '../message_table';

export const PANELS: MessageTable = {
  'What it does': '説明',
  'Exactly: {sentence}': '正確には: {sentence}',
  'More keeps faces where the surface stretches and folds when it moves.':
    '大きくすると、動いたときに伸びたり折れたりする部分の面が残ります。',
  'More keeps faces where the shape is round or sharp.': '大きくすると、丸い部分や尖った部分の面が残ります。',
  'More avoids long thin triangles.': '大きくすると、細長い三角形が減ります。',
  'More makes triangles of about one size.': '大きくすると、三角形の大きさが揃います。',
  'The new surface never leaves the old one by more than this.':
    '新しい表面は、元の表面からこの値を超えて離れません。',
  'No triangle becomes thinner than this.': 'どの三角形もこれより細くなりません。',
  'How far its frequencies may differ from those of the original.': '揺れる速さの変化をこの範囲に抑えます。',
  'Edges sharper than this stay where they are.': 'これより鋭い辺は元の位置に保たれます。',
  'At the end, vertices move a little to restore the shape.':
    '仕上げです。頂点を少し動かして元の形に近づけます。',
  'How many ways of bending and twisting are computed.': '求める曲がり方・ねじれ方の数です。',
  'High: each spot counts by its worst motion. Low: by all motions together.':
    '高いと各部分は最も大きな動きで、低いとすべての動きの合計で評価されます。',
  'Spots that hardly stretch count as if they did not stretch at all.':
    'ほとんど伸びない部分は、伸びないものとして扱います。',
  'How hard it is to stretch: rubber is soft, paper is stiff.':
    '伸びにくさです。ゴムは柔らかく、紙は硬い材料です。',
  'How much it gets thinner when it is pulled longer.': '引き伸ばしたときにどれだけ細くなるかです。',
  'How heavy it is: heavier things swing slower.': '重さです。重いものほどゆっくり揺れます。',
  'How thick the sheet is: thicker ones bend less.': 'シートの厚さです。厚いほど曲がりにくくなります。',
  'How long the motion is.': '動きの長さです。',
  'How soon it comes to rest.': 'どれだけ早く静止するかです。',
  'It cannot pass through itself.': '自分自身を突き抜けなくなります。',
  'How well it grips what it touches.': '触れたものにどれだけ引っかかるかです。',
  'One factor on the stiffness makes the new mesh swing as fast as the old one.':
    '1 つの数値で、新しいメッシュが元と同じ速さで揺れるようにします。',
  '{name} is a settings file for {solver}: open its model first.':
    '{name} は {solver} でのモデルの動きの設定です。先にそのモデルを開いてください。',
  '{name}: {solver} with its parameters, {faces} faces.': '{name}: {solver} とそのパラメーター、{faces} 面。',
  '{name}: {solver} with its parameters. It was written for a model of {original} faces, but this one has {own}, so it is tuned again.':
    '{name}: {solver} とそのパラメーター。{original} 面のモデル用に書き出されたもので、このモデルは {own} 面のため、調整し直します。',
  'nothing moves like mode {mode}{name} any more': 'モード {mode}{name} と同じ動きはなくなりました',
  'mode {mode}{name} is now mode {now}': 'モード {mode}{name} はモード {now} になりました',
  'With these pins {changes}.': 'この固定により、{changes}。',
  'Compare methods': '手法を比較',
  'Comparing methods': '手法を比較しています',
  'Limber, the paper, quadrics and meshoptimizer at the same number of faces: pictures and numbers':
    'Limber、論文、QEM、meshoptimizer を同じ面数で比較します (画像と数値)',
  'Methods at {faces} faces': '{faces} 面での手法の比較',
  'Close the comparison': '比較を閉じる',
  'The same mesh, each at the same number of faces. Drag a picture to turn all of them; click one to use its method.':
    '同じメッシュを同じ面数で比べます。ドラッグするとすべての画像が回転し、クリックするとその手法を使います。',
  'All are measured.': 'すべて測定しました。',
  '{done} of {all} are measured.': '{all} 件中 {done} 件を測定しました。',
  '{method} is shown only for comparison. Limber shows, tests and saves results of its own methods: choose one of the first three.':
    '{method} は比較用です。表示、テスト、保存ができるのは Limber の手法だけなので、最初の 3 つから選んでください。',
  'Pictures of the methods': '各手法の画像',
  'Numbers of the methods': '各手法の数値',
  'waiting ...': '待機中...',
  '{faces} faces, frequencies off by {error} %': '{faces} 面、周波数の誤差 {error} %',
  QEM: 'QEM',
  'meshoptimizer, simplify': 'meshoptimizer (simplify)',
  'meshoptimizer, update + Regularize': 'meshoptimizer (update + Regularize)',
  'Mean distance, %': '平均距離 (%)',
  'Hausdorff distance, %': 'Hausdorff 距離 (%)',
  'Mean frequency error, %': '周波数の平均誤差 (%)',
  'Lowest MAC': '最小 MAC',
  'Smallest angle, °': '最小角 (°)',
  'Area, %': '面積 (%)',
  'Volume, %': '体積 (%)',
  'Time, s': '時間 (秒)',
  changed: '変化あり',
  "Distances in % of the diagonal; frequencies of modes 1 to 10 as shells, as in the report; area and volume against the original. Time runs from the welded mesh to the result, modes and fit included. A limit that stops one of Limber's methods above this number of faces is lifted here. Your weights apply to the chosen method, and only Limber's methods respect pins, locks and paint.":
    '距離は対角線に対する %、周波数はレポートと同じくシェルとしてのモード 1～10、面積と体積は元との差です。時間は結合済みメッシュから結果までで、モードとフィットを含みます。Limber の手法が面数に届く前に止まる制限はここでは外されます。重みは選択中の手法にだけ適用され、固定、ロック、ペイントを考慮するのは Limber の手法だけです。',
  'Copy the table': '表をコピー',
  'Copy as': 'コピー形式',
  'Copy as {format}': '{format} としてコピー',
  Pictures: '画像',
  'Save pictures, videos and figures': '画像・動画・図を保存',
  'Close the pictures': '画像パネルを閉じる',
  'The stage': 'ステージ',
  'As on the screen': '画面と同じ',
  'Twice as large': '2 倍',
  '4K wide': '4K 幅',
  'Width in pixels': '幅 (ピクセル)',
  'Height in pixels': '高さ (ピクセル)',
  pixels: 'ピクセル',
  Legend: '凡例',
  'Transparent background': '背景を透明にする',
  'Save PNG': 'PNG を保存',
  'Drawing the picture': '画像を描画しています',
  Video: '動画',
  Format: '形式',
  'Format of the video': '動画の形式',
  WebM: 'WebM',
  GIF: 'GIF',
  '30 pictures a second; none is dropped, however long one takes to draw.':
    '毎秒 30 フレームです。描画に時間がかかってもフレームは欠けません。',
  '20 pictures a second, at most 960 pixels wide or high: it plays everywhere and in a loop, but its file is larger.':
    '毎秒 20 フレーム、縦横は最大 960 ピクセルです。どこでも繰り返し再生できますが、ファイルは大きくなります。',
  Seconds: '秒数',
  'Save turntable': 'ターンテーブルを保存',
  'One turn around what the stage shows': 'ステージの表示を 1 周します',
  'Recording the turntable': 'ターンテーブルを記録しています',
  'Save motion': '動きを保存',
  'The motion of this step from its start, at its own pace':
    'このステップの動きを最初から実際の速さで記録します',
  'Recording the motion': '動きを記録しています',
  'Save chart as SVG': 'グラフを SVG で保存',
  'The deviation over time': 'ずれの推移',
  'Drawing the chart': 'グラフを描画しています',
  Figure: '図',
  'On one page: original, chosen modes, strain, result, and both in the motion of the Test step.':
    '元、選択したモード、ひずみ、結果、テストのシナリオで動かした両者を 1 ページにまとめます。',
  'Save figure': '図を保存',
  'Simulating both for the figure': '図のために両方を動かしています',
  'Go to Reduce first: the figure shows the result.':
    '図には結果が含まれるため、先に「削減」を開いてください。',
  '{number} models': '{number} 個のモデル',
  'All with the settings of this page: at most {share} % of the faces, as {format}.':
    'すべてこのページの設定で処理します: 面は最大 {share} %、形式は {format}。',
  'All with the settings of this page: at most {share} % of the faces, as {format}; {others}.':
    'すべてこのページの設定で処理します: 面は最大 {share} %、形式は {format}。{others}。',
  'Optimize all {number}': '{number} 個すべてを最適化',
  'Run all again': 'すべて再実行',
  'Cancel the queue': 'キューをキャンセル',
  'Save the queue as .zip': 'キューを .zip で保存',
  'Close the queue': 'キューを閉じる',
  'Progress of the queue': 'キューの進行状況',
  '{done} of {all} done': '{all} 個中 {done} 個完了',
  '{number} done': '完了 {number}',
  '{number} failed': '失敗 {number}',
  '{number} not started': '未開始 {number}',
  waiting: '待機中',
  'running ...': '処理中...',
  done: '完了',
  failed: '失敗',
  'stopped by the deviation limit': 'ずれの制限で停止',
  'stopped by the smallest angle': '最小角の制限で停止',
  'stopped by the frequency limit': '周波数の制限で停止',
  'no edge left to collapse': '縮約できる辺がありません',
  '{before} → {after} faces{stop}, deviation {deviation}, {size}':
    '{before} → {after} 面{stop}、ずれ {deviation}、{size}',
  'The figure is too large for this browser.': '図が大きすぎて、このブラウザーでは描画できません。',
  'A picture of {width} x {height} pixels is too large: choose a smaller one.':
    '{width} x {height} ピクセルの画像は大きすぎます。小さいサイズを選んでください。',
  'The picture is too large to be saved: choose a smaller one.':
    '画像が大きすぎて保存できません。小さいサイズを選んでください。',
  'The simulation has stopped: {why}.': 'シミュレーションが停止しました ({why})。',
  'its program could not be loaded': 'プログラムを読み込めません',
  'Nothing can be picked on this mesh: {why}. Switch the tool off and on to try again.':
    'このメッシュでは頂点を選択できません ({why})。ツールをいったん終了し、もう一度選んでください。',
  'A body has left the scene: raise the substeps of the Test step.':
    '物体がシーンの外に飛び出しました。「テスト」のサブステップを増やしてください。',
  'The link has {word}: give bodies with their faces, as in own=2:400.':
    'リンクに {word} とあります。own=2:400 のように、ボディと面数を指定してください。',
  'The link has {word}: give a whole number.': 'リンクに {word} とあります。整数を指定してください。',
};
