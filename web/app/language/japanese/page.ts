/** The frame of the page: the bar at the top, the start screen, help, words, notices and progress. */

import type { MessageTable } from '../message_table';

export const PAGE: MessageTable = {
  Model: 'モデル',
  Motion: 'モーション',
  Reduce: '削減',
  Test: 'テスト',
  Steps: 'ステップ',
  Panels: 'パネル',
  Settings: '設定',
  'Settings of this step': 'このステップの設定',
  Language: '言語',
  'Drop to open': 'ドロップして開く',
  '{first} {count} others were left out, too.': '{first}ほかの {count} 個も開いていません。',
  '{name} was left out: drop it alone once the model that it was made for is open.':
    '{name} は使われていません。対応するモデルを開いてから、このファイルだけをドロップしてください。',
  Open: '開く',
  'Open a file': 'ファイルを開く',
  'Open a file (Ctrl+O)': 'ファイルを開く (Ctrl+O)',
  Export: '書き出し',
  'Export (Ctrl+E)': '書き出し (Ctrl+E)',
  Undo: '元に戻す',
  'Undo (Ctrl+Z)': '元に戻す (Ctrl+Z)',
  Redo: 'やり直す',
  'Redo (Ctrl+Shift+Z)': 'やり直す (Ctrl+Shift+Z)',
  '1 thread': '1 スレッド',
  'This page has no shared memory (COOP and COEP headers), so the core runs on one thread. Everything works.':
    '共有メモリ (COOP・COEP ヘッダー) が使えないため、1 スレッドで計算します。すべての機能は使えます。',
  'After a reload, this page can use several threads; your work is restored.':
    '再読み込みすると複数のスレッドが使えます。作業内容は復元されます。',
  'Reload for more': '再読み込みして高速化',
  'Colour scheme: {scheme}': '配色: {scheme}',
  'Colour scheme: system, light, dark': '配色: システム、ライト、ダーク',
  Auto: '自動',
  Light: 'ライト',
  Dark: 'ダーク',
  'Share link': 'リンクを共有',
  Copied: 'コピーしました',
  'Copy a link with all settings; the file itself stays here':
    'すべての設定を含むリンクをコピーします。ファイル自体は送られません',
  'The link has {count} characters because it contains what was painted or pinned: some programs cut it off.':
    'ペイントやピンの情報を含むため、リンクは {count} 文字あります。プログラムによっては途中で切れることがあります。',
  'Fewer triangles that still move right': '三角形を減らしても、動きはそのまま',
  'Drop a mesh here: Limber finds how it bends and swings, and removes faces where that does not show.':
    'ここにメッシュをドロップしてください。曲がり方や揺れ方を調べ、動きに影響しない所から面を減らします。',
  'GLB, glTF with its files, OBJ, STL, PLY or OFF, or a ZIP of these.':
    'GLB、glTF (付属ファイルを含む)、OBJ、STL、PLY、OFF、またはこれらの ZIP。',
  'Your file stays on this computer.': 'ファイルは外部に送信されません。',
  'Or try a sample': 'サンプルで試す',
  Samples: 'サンプル',
  bar: '棒',
  cloth: '布',
  tower: '塔',
  organic: '有機形状',
  Bar: '棒',
  'Hanging cloth': '吊るした布',
  'Lattice tower': '鉄骨の塔',
  'Organic shape': '有機的な形',
  "The paper's bar of 8 x 8 x 24 cells, the simplest thing that bends.":
    '論文にある 8 × 8 × 24 セルの棒。曲がるものの中で最も単純な形です。',
  'A square of cotton at rest, hung by two corners.': '2 つの角で吊るした、静止している正方形の綿布です。',
  'Struts, arches and platforms, with hundreds of openings.':
    '支柱、アーチ、足場からなり、数百の開口部があります。',
  'A smooth sculpture of limbs that melt together around its holes.':
    '穴のまわりで枝が滑らかに溶け合う彫刻です。',
  Hint: 'ヒント',
  'Got it': 'わかりました',
  'No hints': 'ヒントを表示しない',
  '{number} of {all}.': '{number} / {all}',
  'Drag to turn the model. The lists show what is in the file and what was repaired. Motion comes next.':
    'ドラッグでモデルを回せます。モデルの一覧には、ファイルの内容と修復した箇所が表示されます。次は「モーション」です。',
  'These are the ways in which the model bends most easily. Click the one that looks like the motion you expect.':
    '最も曲がりやすい動き方の一覧です。想定する動きに近いものをクリックしてください。',
  'Drag the big slider “Kept faces”: faces are removed first where motion does not show. Blink shows the original and the result in turn.':
    '大きなスライダー「残す面数」を動かすと、動きに影響しない所から面が減ります。「切り替え」で元と結果を交互に表示します。',
  'Drag the big slider “Kept faces”: faces are removed first where motion does not show. Compare with V, blink with B.':
    '大きなスライダー「残す面数」を動かすと、動きに影響しない所から面が減ります。V で比較、B で切り替え表示します。',
  'Both meshes move under the same forces. Drag one to pull at it. Export is at the upper right.':
    '2 つのメッシュに同じ力が働きます。ドラッグして引っ張ってみてください。書き出しは右上にあります。',
  Help: 'ヘルプ',
  'Close the help': 'ヘルプを閉じる',
  Close: '閉じる',
  Dismiss: '通知を閉じる',
  Cancel: 'キャンセル',
  Keys: 'キー操作',
  Words: '用語',
  Space: 'Space',
  Home: 'Home',
  Tab: 'Tab',
  Enter: 'Enter',
  Esc: 'Esc',
  'Ctrl+Z': 'Ctrl+Z',
  'Ctrl+O': 'Ctrl+O',
  'Ctrl+E': 'Ctrl+E',
  'play or pause; in Reduce: swing or rest': '再生・一時停止 (「削減」では揺らす・止める)',
  'fit the view': '全体を表示',
  wireframe: 'ワイヤーフレーム',
  'to the step of this number': 'その番号のステップへ',
  'next colours: plain, strain, curvature; in Test: plain, deviation':
    '次の色: 無地、ひずみ、曲率 (「テスト」では無地、ずれ)',
  'blink between original and optimized': '元のメッシュと最適化後を交互に表示',
  'next view: side by side, slider, original, optimized; in Test: overlaid':
    '表示の切り替え: 並べる、スライダー、元、最適化後 (「テスト」では重ねる)',
  'one collapse back or forward; in Test: one step forward':
    '縮約を 1 つ戻す・進める (「テスト」では 1 ステップ進める)',
  'in Test: back to the start': '「テスト」で最初に戻る',
  'in Test: the optimized mesh drives the original': '「テスト」で元のメッシュを最適化後のメッシュで動かす',
  'smaller or larger brush': 'ブラシを小さく・大きく',
  'focus the picture: arrows turn it, Shift and arrows move it, + and - zoom':
    'ビューへ移動: 矢印キーで回転、Shift+矢印キーで移動、+ と - でズーム',
  'in the picture: pin or paint what is in the middle; with Shift, unpin or erase':
    'ビューの中央を固定またはペイント (Shift で解除)',
  'undo; with Shift, redo': '元に戻す (Shift でやり直す)',
  'open a file': 'ファイルを開く',
  export: '書き出し',
  'close this help, the pictures or Export, leave the pick tool or the brush, or cancel what is running':
    'このヘルプ、画像、書き出しを閉じる、選択ツールやブラシを終了、または実行中の処理をキャンセル',
  'this help': 'このヘルプ',
  Mode: 'モード',
  'A way in which the model bends or twists easily.': 'モデルが曲がりやすい、またはねじれやすい形です。',
  'A solution of K phi = omega² M phi, without the rigid motions.':
    'K phi = omega² M phi の解 (剛体運動を除く)。',
  Frequency: '周波数',
  'How fast it swings in that way.': 'その形で揺れる速さです。',
  'omega / 2 pi in Hz, for the unit and material given.': '指定した単位と材料での omega / 2 pi (Hz)。',
  Strain: 'ひずみ',
  'Where the surface is stretched when it moves.': '動いたときに表面が伸びる場所です。',
  'Norm of the Green-Lagrange strain of the mode shape, ranked 0 to 1.':
    'モード形状の Green-Lagrange ひずみのノルムを 0 から 1 の順位で表したもの。',
  Deviation: 'ずれ',
  'How far the new surface is from the old one where they differ most.':
    '新しい表面が元の表面から最も離れた所での距離です。',
  'Hausdorff distance both ways, in % of the diagonal.': '双方向の Hausdorff 距離 (対角線に対する %)。',
  'Smallest angle': '最小角',
  'How thin the thinnest triangle is.': '最も細い三角形の鋭さです。',
  'Of all corners, in degrees; thin triangles make simulations stiff.':
    'すべての角の最小値 (度)。細い三角形はシミュレーションを硬くします。',
  Topology: 'トポロジー',
  'Parts, holes and open borders: these do not change.': 'パーツ、穴、開いた境界。元のまま保たれます。',
  'Components, genus and boundary loops, certified after every run.':
    '連結成分、種数、境界ループ。実行のたびに確認します。',
  Seam: 'シーム',
  'Where the texture is cut; both sides stay together.': 'テクスチャの切れ目です。両側は離れません。',
  'An edge at which the attributes of its two triangles differ.': '両側の三角形で属性が異なる辺。',
  Pinned: '固定',
  'Held in place.': 'その場に固定されています。',
  'Vertices without degrees of freedom, in modes and simulations.':
    'モードとシミュレーションで自由度を持たない頂点。',
  Fit: 'フィット',
  'After faces are removed, vertices are moved a little to restore the shape.':
    '面を減らした後、形が元に近づくように頂点を少し動かします。',
  'Least squares distance to the original under limits, or residuals of frequencies.':
    '制限の下での元の形状との距離の最小二乗、または周波数の残差。',
  Tuned: '調整済み',
  'The numbers for your engine with which the new mesh moves like the old one.':
    '新しいメッシュが元と同じように動く、エンジン用の数値です。',
  'Factors on stretching and bending and masses per vertex.': '伸びと曲げの係数、および頂点ごとの質量。',
  'Noise floor': 'ノイズフロア',
  'How much the original differs from itself when computed in another way: smaller differences mean nothing.':
    '元のメッシュ自身の計算誤差です。これより小さい差に意味はありません。',
  'The original simulated with its constraints in another order.':
    '拘束の順序を変えて元のメッシュを計算したもの。',
  exactly: '正確には',
  '{task}: stopped.': '{task}: 停止しました。',
  'Run again': '再実行',
  '{number} of {all}': '{number} / {all}',
  ', {seconds} s left': '、残り {seconds} 秒',
  ', {minutes} min left': '、残り {minutes} 分',
  'Your last work, on {name}, is stored on this computer.':
    '前回の作業 ({name}) がこのコンピューターに保存されています。',
  'Open it': '開く',
  'Your earlier work on {name} is restored.': '{name} への前回の編集内容を復元しました。',
  'Start anew': '最初からやり直す',
  'The link has an error.': 'リンクに誤りがあります。',
  'This link is for {file}: open that file.': 'このリンクは {file} 用です。そのファイルを開いてください。',
  'A new version is ready. Your work is restored after a reload.':
    '新しいバージョンがあります。再読み込み後も作業内容は復元されます。',
  Reload: '再読み込み',
  'Start again': 'やり直す',
  '{name} cannot be read: it was moved or changed in the meantime, or is too large for this browser.':
    '{name} を読み込めません。移動または変更されたか、このブラウザーには大きすぎます。',
  '{name} could not be loaded: build the samples with npm run build.':
    '{name} を読み込めませんでした。npm run build でサンプルを作成してください。',
  'The computation has stopped unexpectedly. It was restarted, and your work is unchanged.':
    '計算が予期せず停止したため、再開しました。作業内容はそのままです。',
  'A part of the page could not be loaded: the network is down, or there is a new version. Reload; your work is restored.':
    'ページの一部を読み込めませんでした。ネットワークが切れたか、新しいバージョンがあります。再読み込みしてください。作業内容は復元されます。',
  'The computation has stopped unexpectedly: {why}. Your file and your settings are kept.':
    '計算が予期せず停止しました ({why})。ファイルと設定は保たれています。',
  '{task}: no progress for a minute. It may need more time or be stuck.':
    '{task}: 1 分間進んでいません。時間がかかっているか、停止している可能性があります。',
  'The simulation has stopped: {why}. Press Reset to start it again.':
    'シミュレーションが停止しました ({why})。「リセット」で再開できます。',
  'its program could not be loaded; reload the page, and your work is restored':
    'プログラムを読み込めません。再読み込みしてください。作業内容は復元されます',
  'the browser has ended it': 'ブラウザーが終了しました',
};
