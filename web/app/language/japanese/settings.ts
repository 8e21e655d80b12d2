/** The settings of the page: their labels, help and units. */

import type { MessageTable } from '../message_table';

export const SETTINGS: MessageTable = {
  'Shape, triangle sizes and strain guide the collapses; then the result is fitted to the surface':
    '形状、三角形の大きさ、ひずみを指針に縮約し、その後で表面にフィットします',
  Paper: '論文',
  'Strain, curvature and triangle shape guide the collapses (Eq. 11 of the paper)':
    'ひずみ、曲率、三角形の形を指針に縮約します (論文の式 11)',
  'Shape only': '形状のみ',
  'Area-weighted quadrics only': '面積で重み付けした二次誤差のみを使います',
  'Keep where it bends': '曲がる所を残す',
  'Weight of the strain rank in the cost of an edge (for paper: alpha of Eq. 11, 0.05).':
    '辺のコストでのひずみの順位の重み (「論文」では式 11 の alpha: 0.05)。',
  'Keep the shape': '形状を保つ',
  'Paper only: weight of the curvature in the cost of an edge (beta of Eq. 11).':
    '「論文」のみ: 辺のコストでの曲率の重み (式 11 の beta)。',
  'Even triangles': '三角形の形を整える',
  'Weight of the triangle shape in the cost of an edge (for paper: gamma of Eq. 11, 0.01).':
    '辺のコストでの三角形の形の重み (「論文」では式 11 の gamma: 0.01)。',
  'Even sizes': '大きさを揃える',
  'Weight of the squared length of an edge in its cost (not used by paper; 0 for qem).':
    '辺のコストでの長さの 2 乗の重み (「論文」では使いません。「形状のみ」では 0)。',
  "Limber only: after the collapses, move vertices slightly: onto the original's surface, keeping outline, corners and area (surface); so that the result, as a thin shell, vibrates like the original (modal; called on in version 0.1); or not at all (off).":
    '「モーション」のみ: 縮約後に頂点を少し動かします。輪郭・角・面積を保って元の表面に合わせる、シェルとして元と同じように振動させる、または動かさない、から選びます。',
  'Largest deviation': 'ずれの上限',
  'Stop before the surface of a body deviates from the original by more than this, in % of its diagonal; 0 sets no limit.':
    '表面が元からこれより離れる前に停止します (対角線に対する %)。0 は制限なし。',
  'Stop before a collapse makes an angle smaller than this where the input has none; 0 sets no limit.':
    '入力にない、これより小さい角ができる前に停止します。0 は制限なし。',
  'Largest frequency error': '周波数誤差の上限',
  'Keep the fewest faces with which each of the first six frequencies stays within this of the original, in %; 0 sets no limit. With a solver, the limit applies to the mean error of the first ten frequencies there, after tuning.':
    '最初の 6 つの周波数の誤差がこの値 (%) 以内に収まる、最少の面数を残します。0 は制限なし。ソルバーを選んだ場合は、調整後の最初の 10 個の平均誤差です。',
  'Further levels': '追加の LOD',
  Creases: '折り目',
  'Keep edges at which the normals of the two faces differ by more than this, in degrees; 0 keeps none.':
    'これより大きく折れた辺を保ちます (度)。0 は保持なし。',
  'Keep triangles where': '三角形を残す場所',
  'Name of an attribute whose first component (0 to 1) marks where to keep triangles: a collapse there costs up to 100 times as much.':
    '第 1 成分 (0 から 1) で三角形を残す場所を示す属性の名前。縮約のコストが最大 100 倍になります。',
  'Locked vertices': 'ロックする頂点',
  'Modes to compute': '計算するモード数',
  'Number of elastic modes to compute for each part.': '各パーツで計算する弾性モードの数。',
  'Norm over the modes': 'モードのノルム',
  'Norm that combines the modes (p of Eq. 6): 1 is the sum, 2 the Euclidean norm, inf the maximum.':
    'モードの足し合わせ方 (式 6 の p): 1 は和、2 はユークリッド、inf は最大値。',
  'Strain that counts': '有効なひずみ',
  'Strain ranks below this count as 0.': 'これより低いひずみの順位は無視します。',
  'Laplacian only: the axis along which modes move: x, y, z, or all (each principal axis in turn).':
    'ラプラシアンのみ: モードが動く軸 (x、y、z)。「すべて」は各主軸を順に使います。',
  'Vertices to hold in place: low:PCT, high:PCT (ends of the longest axis), box:x0,y0,z0,x1,y1,z1, attribute:NAME, vertices:i,j, joined by +.':
    '固定する場所: low:%、high:% (最も長い軸の端)、box:x0,y0,z0,x1,y1,z1、attribute:属性名、vertices:i,j。+ でつなげます。',
  'Solve the mesh itself': 'メッシュを直接計算',
  "Young's modulus": 'ヤング率',
  "Young's modulus: the stiffness of the material.": '材料の硬さ。',
  "Poisson's ratio": 'ポアソン比',
  "Poisson's ratio: how much the material narrows when it is stretched.":
    '伸ばしたときに材料が細くなる度合い。',
  Density: '密度',
  'Mass of a cubic metre of the material.': '材料 1 立方メートルの質量。',
  Thickness: '厚さ',
  'Thickness of the shell in % of the diagonal of the body.': 'シェルの厚さ (物体の対角線に対する %)。',
  'One unit of the file': 'ファイルの 1 単位',
  'Length of one unit of the file in metres; it changes frequencies, not the mesh.':
    'ファイルの 1 単位の長さ (メートル)。周波数だけに影響し、メッシュは変わりません。',
  'Where it will move': '使用するソルバー',
  'Tuned by': '調整方法',
  'Your parameters': '独自のパラメーター',
  'Scenario: twist (the upper end turns by 45 degrees), sway (a sideways blow), hang (gravity), drop (onto a floor), pull (the upper end moves by a fifth of the length), wind, or drape (onto a ball).':
    '動きの内容: ねじる (上端を 45 度回す)、揺らす (横からの衝撃)、吊るす (重力)、落とす (床へ)、引っ張る (上端を長さの 5 分の 1)、風、被せる (球へ)。',
  Duration: '時間',
  'Length of the simulated motion.': 'シミュレーションの長さ。',
  Substeps: 'サブステップ',
  'Substeps per step of 1/60 s; more of them make stiff or fine meshes more accurate (the paper uses 2,000).':
    '1/60 秒のステップを分割する数。硬いメッシュや細かいメッシュは、増やすほど正確になります (論文では 2,000)。',
  Damping: '減衰',
  'Rate at which motion dies away.': '動きが自然に収まる速さ。',
  'Touches itself': '自己衝突',
  'Sheets collide with themselves; for cloth with even triangles, and slower. No effect on solids; closed bodies of shells or springs always collide with themselves when dropped.':
    'シート同士が触れると押し返します。三角形の揃った布向けで、計算は遅くなります。ソリッドには効果がなく、シェルやばねの閉じた物体を落とすときは常に有効です。',
  'Can touch': '衝突対象',
  'Colliders for both bodies in addition to those of the scenario, in units of the body: ground:HEIGHT (normal to y), ball:x,y,z,R, capsule:x0,y0,z0,x1,y1,z1,R, joined by +.':
    'シナリオのほかに衝突する対象 (物体の単位): ground:高さ (y 方向)、ball:x,y,z,R、capsule:x0,y0,z0,x1,y1,z1,R。+ でつなげます。',
  Friction: '摩擦',
  'Friction coefficient against the ground and colliders: the ratio of the friction force to the normal force.':
    '床や衝突対象との摩擦。押し付ける力のうち、滑りを止める割合。',
  Calibrated: '較正',
  'Scale the stiffness of the optimized mesh by the factor that best matches its first ten frequencies to those of the original (as shells); a calibrated body is simulated as a shell.':
    '最適化後のメッシュの最初の 10 個の周波数が元と一致する剛性の係数を (シェルとして) 求めて使います。較正した物体はシェルとして動きます。',
  Compression: '圧縮',
  'Weld distance': '結合距離',
  'Merge vertices closer than this, in % of the diagonal; 0 merges equal positions only.':
    'これより近い頂点を 1 つにします (対角線に対する %)。0 は同じ位置の頂点だけを結合します。',
  degrees: '度',
};
