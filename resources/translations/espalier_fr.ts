<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR" sourcelanguage="en">
<context>
    <name>AnsweredDoubts</name>
    <message>
        <source>the answers in this project cannot be read: what was answered is asked again</source>
        <translation>les réponses de ce projet ne peuvent pas être lues&#xa0;: les questions déjà répondues sont posées à nouveau</translation>
    </message>
</context>
<context>
    <name>ComparisonColors</name>
    <message>
        <source>the reference</source>
        <translation>la référence</translation>
    </message>
    <message>
        <source>Compared with %1</source>
        <translation>Comparé avec %1</translation>
    </message>
</context>
<context>
    <name>CoverageText</name>
    <message>
        <source>1 node</source>
        <translation>1 nœud</translation>
    </message>
    <message>
        <source>%1 nodes</source>
        <translation>%1 nœuds</translation>
    </message>
</context>
<context>
    <name>Differences</name>
    <message>
        <source>Matched</source>
        <translation>Apparié</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Manqué</translation>
    </message>
    <message>
        <source>Invented</source>
        <translation>Inventé</translation>
    </message>
    <message>
        <source>Wrongly attached</source>
        <translation>Mal attaché</translation>
    </message>
</context>
<context>
    <name>DoubtText</name>
    <message>
        <source>Is this branch wood? %1 long</source>
        <translation>Cette branche est-elle du bois&#xa0;? Longueur&#xa0;: %1</translation>
    </message>
    <message>
        <source>What does this branch grow from? %1 long</source>
        <translation>D’où part cette branche&#xa0;? Longueur&#xa0;: %1</translation>
    </message>
    <message>
        <source>Is there a branch along these points? %1 long</source>
        <translation>Y a-t-il une branche le long de ces points&#xa0;? Longueur&#xa0;: %1</translation>
    </message>
    <message>
        <source>no branch</source>
        <translation>pas de branche</translation>
    </message>
    <message>
        <source>as it is</source>
        <translation>telle quelle</translation>
    </message>
    <message>
        <source>no wood</source>
        <translation>pas du bois</translation>
    </message>
    <message>
        <source>from node %1</source>
        <translation>du nœud %1</translation>
    </message>
    <message>
        <source>a branch</source>
        <translation>une branche</translation>
    </message>
    <message>
        <source>No wood?</source>
        <translation>Pas du bois&#xa0;?</translation>
    </message>
    <message>
        <source>Grows elsewhere?</source>
        <translation>Pousse ailleurs&#xa0;?</translation>
    </message>
    <message>
        <source>Missing branch?</source>
        <translation>Branche absente&#xa0;?</translation>
    </message>
</context>
<context>
    <name>EmptyView</name>
    <message>
        <source>All layers are off: choose one in View &gt; Layers</source>
        <translation>Tous les calques sont éteints&#xa0;: choisissez-en un dans Vue &gt; Calques</translation>
    </message>
    <message>
        <source>Nothing lies in the slab or the box of Clipping here.   {show_all} shows all of the plant</source>
        <translation>Rien n’est ici dans la tranche ou la boîte du découpage.   {show_all} affiche toute la plante</translation>
    </message>
    <message>
        <source>The points that are here are set aside, or hidden as explained</source>
        <translation>Les points d’ici sont mis de côté, ou masqués car expliqués</translation>
    </message>
    <message>
        <source>What is here is hidden.   {show_all} shows all of the plant</source>
        <translation>Ce qui est ici est masqué.   {show_all} affiche toute la plante</translation>
    </message>
    <message>
        <source>The plant is not in view.   {frame_all} shows all of it</source>
        <translation>La plante est hors de la vue.   {frame_all} la cadre en entier</translation>
    </message>
</context>
<context>
    <name>ErrorReasonText</name>
    <message>
        <source>no point is near %1 of it</source>
        <translation>aucun point n’est près de %1 de sa longueur</translation>
    </message>
    <message>
        <source>its first %1 have no points of their own</source>
        <translation>son début, sur %1, n’a pas de points à lui</translation>
    </message>
    <message>
        <source>its points lie %1 off its surface</source>
        <translation>ses points sont à %1 de sa surface</translation>
    </message>
    <message>
        <source>%1 points lie on %2 of it</source>
        <translation>%1 points se trouvent sur %2 de sa longueur</translation>
    </message>
    <message>
        <source>%1 points beside it belong to no wood</source>
        <translation>%1 points à côté n’appartiennent à aucun bois</translation>
    </message>
    <message>
        <source>other wood is %1 from it</source>
        <translation>un autre bois est à %1</translation>
    </message>
    <message>
        <source>it lies in other wood</source>
        <translation>il se trouve dans un autre bois</translation>
    </message>
    <message>
        <source>it turns by %1° where it begins</source>
        <translation>il tourne de %1° à son départ</translation>
    </message>
    <message>
        <source>the checks find its shape unlikely</source>
        <translation>les contrôles jugent sa forme improbable</translation>
    </message>
    <message>
        <source>its end is a shoot with a probability of %1 only</source>
        <translation>son extrémité est une pousse avec une probabilité de %1 seulement</translation>
    </message>
    <message>
        <source>it bears further wood</source>
        <translation>il porte d’autre bois</translation>
    </message>
    <message>
        <source>with a probability of %1, it belongs elsewhere than across the gap below it</source>
        <translation>avec une probabilité de %1, sa place est ailleurs qu’au-delà de la lacune située dessous</translation>
    </message>
    <message>
        <source>branches of this size are often wrong</source>
        <translation>les branches de cette taille sont souvent fausses</translation>
    </message>
    <message>
        <source>wood of this radius (%1) is often wrong</source>
        <translation>le bois de ce rayon (%1) est souvent faux</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>; </source>
        <translation>&#xa0;; </translation>
    </message>
</context>
<context>
    <name>EvaluationText</name>
    <message>
        <source>how this project compares with its reference cannot be read: choose the tolerance again</source>
        <translation>la comparaison de ce projet avec sa référence ne peut pas être lue&#xa0;: choisissez à nouveau la tolérance</translation>
    </message>
</context>
<context>
    <name>FilePlace</name>
    <message>
        <source>line %1</source>
        <translation>ligne %1</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>colonne %1</translation>
    </message>
    <message>
        <source>byte %1</source>
        <translation>octet %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>FindingRemedy</name>
    <message>
        <source>attaches it elsewhere</source>
        <translation>l’attache ailleurs</translation>
    </message>
    <message>
        <source>removes the node</source>
        <translation>supprime le nœud</translation>
    </message>
    <message>
        <source>joins it to the nearest tree</source>
        <translation>le joint à l’arbre le plus proche</translation>
    </message>
    <message>
        <source>lets the axis go on</source>
        <translation>laisse l’axe se poursuivre</translation>
    </message>
    <message>
        <source>makes it thinner</source>
        <translation>l’amincit</translation>
    </message>
    <message>
        <source>removes them</source>
        <translation>les supprime</translation>
    </message>
    <message>
        <source>moves it to their middle</source>
        <translation>le déplace en leur milieu</translation>
    </message>
    <message>
        <source>moves it to its points</source>
        <translation>le déplace vers ses points</translation>
    </message>
    <message>
        <source>moves the root down</source>
        <translation>descend la racine</translation>
    </message>
    <message>
        <source>grows a branch from them</source>
        <translation>en fait partir une branche</translation>
    </message>
    <message>
        <source>keeps the straightest and thickest, others branch</source>
        <translation>garde la suite la plus droite et épaisse, ramifie les autres</translation>
    </message>
    <message>
        <source>removes them: the plant begins above</source>
        <translation>les enlève&#xa0;: la plante commence au-dessus</translation>
    </message>
</context>
<context>
    <name>FindingTitle</name>
    <message>
        <source>Separate pieces</source>
        <translation>Morceaux séparés</translation>
    </message>
    <message>
        <source>Two successors</source>
        <translation>Deux successeurs</translation>
    </message>
    <message>
        <source>Lone branches</source>
        <translation>Ramifications seules</translation>
    </message>
    <message>
        <source>Zero-length edges</source>
        <translation>Arêtes de longueur nulle</translation>
    </message>
    <message>
        <source>Duplicated edges</source>
        <translation>Arêtes en double</translation>
    </message>
    <message>
        <source>Sharp turns</source>
        <translation>Virages brusques</translation>
    </message>
    <message>
        <source>Touching branches</source>
        <translation>Branches qui se touchent</translation>
    </message>
    <message>
        <source>Loops</source>
        <translation>Boucles</translation>
    </message>
    <message>
        <source>Thick on thin</source>
        <translation>Gros sur mince</translation>
    </message>
    <message>
        <source>Edges off the scan</source>
        <translation>Arêtes hors du scan</translation>
    </message>
    <message>
        <source>No points of their own</source>
        <translation>Pas de points propres</translation>
    </message>
    <message>
        <source>Beside its points</source>
        <translation>À côté de ses points</translation>
    </message>
    <message>
        <source>Short foot</source>
        <translation>Pied trop court</translation>
    </message>
    <message>
        <source>Bare twigs</source>
        <translation>Brindilles nues</translation>
    </message>
    <message>
        <source>Separate piece</source>
        <translation>Morceau séparé</translation>
    </message>
    <message>
        <source>Lone branch</source>
        <translation>Ramification seule</translation>
    </message>
    <message>
        <source>Zero-length edge</source>
        <translation>Arête de longueur nulle</translation>
    </message>
    <message>
        <source>Duplicated edge</source>
        <translation>Arête en double</translation>
    </message>
    <message>
        <source>Sharp turn</source>
        <translation>Virage brusque</translation>
    </message>
    <message>
        <source>Touching branch</source>
        <translation>Branche qui touche</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Boucle</translation>
    </message>
    <message>
        <source>Off the scan</source>
        <translation>Hors du scan</translation>
    </message>
    <message>
        <source>No own points</source>
        <translation>Pas de points propres</translation>
    </message>
    <message>
        <source>Bare twig</source>
        <translation>Brindille nue</translation>
    </message>
</context>
<context>
    <name>FindingsText</name>
    <message>
        <source>what is ignored in this project cannot be read: all findings are shown</source>
        <translation>ce qui est ignoré dans ce projet ne peut pas être lu&#xa0;: tous les constats sont affichés</translation>
    </message>
    <message>
        <source>the limits of the checks in this project cannot be read: the usual ones hold</source>
        <translation>les limites des contrôles de ce projet ne peuvent pas être lues&#xa0;: les limites habituelles s’appliquent</translation>
    </message>
</context>
<context>
    <name>HandWork</name>
    <message>
        <source>under a minute</source>
        <translation>moins d’une minute</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>%1 added</source>
        <translation>ajoutés&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 removed</source>
        <translation>supprimés&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 moved</source>
        <translation>déplacés&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 reparented</source>
        <translation>rattachés&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 with another edge type</source>
        <translation>avec un autre type d’arête&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 with another radius</source>
        <translation>avec un autre rayon&#xa0;: %1</translation>
    </message>
    <message>
        <source>1 edit</source>
        <translation>1 modification</translation>
    </message>
    <message>
        <source>%1 edits</source>
        <translation>%1 modifications</translation>
    </message>
    <message>
        <source>%1; nodes: %2</source>
        <translation>%1&#xa0;; nœuds %2</translation>
    </message>
</context>
<context>
    <name>HistogramPlot</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>%1: %2 of %3 (%4)</source>
        <translation>%1&#xa0;: %2 sur %3 (%4)</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Contour</translation>
    </message>
    <message>
        <source>%1 – %2 · %3 (%4)</source>
        <translation>%1 – %2 · %3 (%4)</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>Calcul en cours…</translation>
    </message>
    <message>
        <source>No values</source>
        <translation>Aucune valeur</translation>
    </message>
</context>
<context>
    <name>JudgedNumbers</name>
    <message>
        <source>Residual thickness</source>
        <translation>Épaisseur résiduelle</translation>
    </message>
    <message>
        <source>spacings</source>
        <translation>espacements</translation>
    </message>
    <message>
        <source>How far contracted points lie from the axis through those near them: the root mean square near each place of the plant, and of these the median</source>
        <translation>À quelle distance les points contractés se trouvent de l’axe qui passe par leurs voisins&#xa0;: la moyenne quadratique autour de chaque endroit de la plante, puis la médiane de ces valeurs</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <source>On a line</source>
        <translation>Sur une ligne</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Share of points whose contracted neighbors lie on a line</source>
        <translation>Part des points dont les voisins contractés sont sur une ligne</translation>
    </message>
    <message>
        <source>Ends of the scan</source>
        <translation>Extrémités du scan</translation>
    </message>
    <message>
        <source>Ends of branches, as the points show</source>
        <translation>Extrémités des branches, telles que les points les montrent</translation>
    </message>
    <message>
        <source>Lost ends</source>
        <translation>Bouts perdus</translation>
    </message>
    <message>
        <source>Ends of branches with no tip of the skeleton within 7 spacings, or without a skeleton no contracted point</source>
        <translation>Extrémités de branches sans extrémité du squelette à moins de 7 espacements ou, sans squelette, sans point contracté</translation>
    </message>
    <message>
        <source>Bridged places</source>
        <translation>Endroits pontés</translation>
    </message>
    <message>
        <source>Places where contracted points lie together that are far apart along the plant</source>
        <translation>Endroits où se rejoignent des points contractés qui sont éloignés le long de la plante</translation>
    </message>
    <message>
        <source>Bridged</source>
        <translation>Ponts</translation>
    </message>
    <message>
        <source>Unexplained points</source>
        <translation>Points inexpliqués</translation>
    </message>
    <message>
        <source>Points that are contracted to more than 3 spacings off the wood of the skeleton</source>
        <translation>Points contractés à plus de 3 espacements du bois du squelette</translation>
    </message>
    <message>
        <source>Unexplained</source>
        <translation>Inexpliqués</translation>
    </message>
    <message>
        <source>Length of the skeleton</source>
        <translation>Longueur du squelette</translation>
    </message>
    <message>
        <source>Of all its edges</source>
        <translation>De toutes ses arêtes</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>Nœuds</translation>
    </message>
    <message>
        <source>Nodes of the skeleton</source>
        <translation>Nœuds du squelette</translation>
    </message>
    <message>
        <source>Green: the contracted points.</source>
        <translation>Vert&#xa0;: les points contractés.</translation>
    </message>
    <message>
        <source>Gray: the scanned points.</source>
        <translation>Gris&#xa0;: les points scannés.</translation>
    </message>
    <message>
        <source>Black: the skeleton, with edges that branch off in vermillion.</source>
        <translation>Noir&#xa0;: le squelette, avec les arêtes de ramification en vermillon.</translation>
    </message>
</context>
<context>
    <name>LengthUnitText</name>
    <message>
        <source>1 byte</source>
        <translation>1 octet</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 octets</translation>
    </message>
    <message>
        <source>%1 kB</source>
        <translation>%1 ko</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 Mo</translation>
    </message>
    <message>
        <source>%1 GB</source>
        <translation>%1 Go</translation>
    </message>
</context>
<context>
    <name>LoadFiles</name>
    <message>
        <source>%1: one scan too many: open two at most, to register one to the other</source>
        <translation>%1&#xa0;: un scan de trop&#xa0;: ouvrez-en deux au plus, pour recaler l’un sur l’autre</translation>
    </message>
    <message>
        <source>%1: a second skeleton: open one at a time</source>
        <translation>%1&#xa0;: un second squelette&#xa0;: ouvrez-en un seul à la fois</translation>
    </message>
</context>
<context>
    <name>LoadReference</name>
    <message>
        <source>%1 is a scan: a reference is a structure, as an MTG</source>
        <translation>%1 est un scan&#xa0;: une référence est une structure, par exemple un MTG</translation>
    </message>
</context>
<context>
    <name>LookedAt</name>
    <message>
        <source>nothing is marked, as %1 nodes are more than one looks at in one go: walk to them by %2, or choose Review &gt; %3</source>
        <translation>rien n’est marqué, car %1 nœuds sont trop pour un seul coup d’œil&#xa0;: parcourez-les avec %2, ou choisissez Révision &gt; %3</translation>
    </message>
    <message>
        <source>nothing is marked, as the skeleton is not shown: choose %1</source>
        <translation>rien n’est marqué, car le squelette n’est pas affiché&#xa0;: choisissez %1</translation>
    </message>
    <message>
        <source>%1 hidden</source>
        <translation>%1 masqué(s)</translation>
    </message>
    <message>
        <source>%1 clipped away</source>
        <translation>%1 hors du découpage</translation>
    </message>
    <message>
        <source>%1 outside the view</source>
        <translation>%1 hors de la vue</translation>
    </message>
    <message>
        <source>%1 was</source>
        <translation>%1 était</translation>
    </message>
    <message>
        <source>%1 of the %2 nodes selected was</source>
        <translation>%1 des %2 nœuds sélectionnés était</translation>
    </message>
    <message>
        <source>%1 of the %2 nodes selected were</source>
        <translation>%1 des %2 nœuds sélectionnés étaient</translation>
    </message>
</context>
<context>
    <name>MethodsText</name>
    <message>
        <source>the table of methods in this project cannot be read: add the structures again</source>
        <translation>le tableau des méthodes de ce projet ne peut pas être lu&#xa0;: ajoutez à nouveau les structures</translation>
    </message>
</context>
<context>
    <name>NodeChoices</name>
    <message>
        <source>a path has two ends: select a first and a last node</source>
        <translation>un chemin a deux extrémités&#xa0;: sélectionnez un premier et un dernier nœud</translation>
    </message>
    <message>
        <source>all nodes are reviewed: there is nothing to select</source>
        <translation>tous les nœuds sont révisés&#xa0;: il n’y a rien à sélectionner</translation>
    </message>
    <message>
        <source>no two nodes lie together: there is nothing to select</source>
        <translation>aucun nœud n’est au même endroit qu’un autre&#xa0;: il n’y a rien à sélectionner</translation>
    </message>
    <message>
        <source>no branch runs along another one: there is nothing to select</source>
        <translation>aucune branche n’en longe une autre&#xa0;: il n’y a rien à sélectionner</translation>
    </message>
    <message>
        <source>%1 has no child</source>
        <translation>%1 n’a pas d’enfant</translation>
    </message>
    <message>
        <source>%1 is a root</source>
        <translation>%1 est une racine</translation>
    </message>
    <message>
        <source>%1 has no sibling</source>
        <translation>%1 n’a pas de frère</translation>
    </message>
    <message>
        <source>Select &amp;Downstream</source>
        <translation>Sélectionner l’&amp;aval</translation>
    </message>
    <message>
        <source>The node and all that it carries</source>
        <translation>Le nœud et tout ce qu’il porte</translation>
    </message>
    <message>
        <source>Select to &amp;Root</source>
        <translation>Sélectionner jusqu’à la &amp;racine</translation>
    </message>
    <message>
        <source>The node and all that carries it</source>
        <translation>Le nœud et tout ce qui le porte</translation>
    </message>
    <message>
        <source>Select A&amp;xis</source>
        <translation>Sélectionner l’a&amp;xe</translation>
    </message>
    <message>
        <source>The whole axis of the node</source>
        <translation>L’axe entier du nœud</translation>
    </message>
    <message>
        <source>Select &amp;Order</source>
        <translation>Sélectionner l’&amp;ordre</translation>
    </message>
    <message>
        <source>All nodes of the same order</source>
        <translation>Tous les nœuds du même ordre</translation>
    </message>
    <message>
        <source>Select &amp;Tree</source>
        <translation>Sélectionner l’ar&amp;bre</translation>
    </message>
    <message>
        <source>All that is connected with the node</source>
        <translation>Tout ce qui est relié au nœud</translation>
    </message>
    <message>
        <source>&amp;Invert Selection</source>
        <translation>&amp;Inverser la sélection</translation>
    </message>
    <message>
        <source>All other nodes</source>
        <translation>Tous les autres nœuds</translation>
    </message>
    <message>
        <source>Select &amp;Unreviewed</source>
        <translation>Sélectionner les non révisé&amp;s</translation>
    </message>
    <message>
        <source>All nodes that are to do or doubtful</source>
        <translation>Tous les nœuds à faire ou douteux</translation>
    </message>
    <message>
        <source>Select &amp;Path Between</source>
        <translation>Sélectionner le &amp;chemin entre</translation>
    </message>
    <message>
        <source>All nodes from the first to the last one selected</source>
        <translation>Tous les nœuds du premier au dernier sélectionné</translation>
    </message>
    <message>
        <source>Select &amp;Similar Radius</source>
        <translation>Sélectionner les rayons se&amp;mblables</translation>
    </message>
    <message>
        <source>All nodes whose radius is within 20 %</source>
        <translation>Tous les nœuds dont le rayon est le même à 20 % près</translation>
    </message>
    <message>
        <source>&amp;Grow Selection</source>
        <translation>Ét&amp;endre la sélection</translation>
    </message>
    <message>
        <source>Adds the nodes that are linked to it</source>
        <translation>Lui ajoute les nœuds qui lui sont liés</translation>
    </message>
    <message>
        <source>Shri&amp;nk Selection</source>
        <translation>Ré&amp;duire la sélection</translation>
    </message>
    <message>
        <source>Leaves out its nodes at the border</source>
        <translation>En retire les nœuds du bord</translation>
    </message>
    <message>
        <source>To Child</source>
        <translation>Vers l’enfant</translation>
    </message>
    <message>
        <source>On along the axis, from the node that is selected; from none, to a root</source>
        <translation>Plus loin le long de l’axe, depuis le nœud sélectionné&#xa0;; sans sélection, vers une racine</translation>
    </message>
    <message>
        <source>To Parent</source>
        <translation>Vers le parent</translation>
    </message>
    <message>
        <source>Back along the axis, or to what bears it</source>
        <translation>En arrière le long de l’axe, ou vers ce qui le porte</translation>
    </message>
    <message>
        <source>To Next Sibling</source>
        <translation>Vers le frère suivant</translation>
    </message>
    <message>
        <source>To the next child of the same parent</source>
        <translation>Vers l’enfant suivant du même parent</translation>
    </message>
    <message>
        <source>To Previous Sibling</source>
        <translation>Vers le frère précédent</translation>
    </message>
    <message>
        <source>To the child before of the same parent</source>
        <translation>Vers l’enfant précédent du même parent</translation>
    </message>
    <message>
        <source>Select Duplicated Nodes</source>
        <translation>Sélectionner les nœuds en double</translation>
    </message>
    <message>
        <source>Nodes nearer to each other than a quarter of an edge</source>
        <translation>Les nœuds plus proches l’un de l’autre qu’un quart d’arête</translation>
    </message>
    <message>
        <source>Select Duplicated Branches</source>
        <translation>Sélectionner les branches en double</translation>
    </message>
    <message>
        <source>Branches that run along another one</source>
        <translation>Les branches qui en longent une autre</translation>
    </message>
</context>
<context>
    <name>NodeEdits</name>
    <message>
        <source>New child of %1</source>
        <translation>Nouvel enfant&#xa0;: %1</translation>
    </message>
    <message>
        <source>Split the edge of %1</source>
        <translation>Scinder l’arête&#xa0;: %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Supprimer&#xa0;: %1</translation>
    </message>
    <message>
        <source>Remove the subtree of %1</source>
        <translation>Supprimer le sous-arbre&#xa0;: %1</translation>
    </message>
    <message>
        <source>Make %1 axial</source>
        <translation>Passer en axe&#xa0;: %1</translation>
    </message>
    <message>
        <source>Make %1 branching</source>
        <translation>Passer en ramification&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 has no radius yet: type one in the inspector</source>
        <translation>%1 n’a pas encore de rayon&#xa0;: saisissez-en un dans l’inspecteur</translation>
    </message>
    <message>
        <source>there are no points to stick to: open the scan first</source>
        <translation>il n’y a pas de points où coller&#xa0;: ouvrez d’abord le scan</translation>
    </message>
    <message>
        <source>Extend the foot at %1</source>
        <translation>Prolonger le pied&#xa0;: %1</translation>
    </message>
    <message>
        <source>no points go on below %1: choose the root of a stem</source>
        <translation>aucun point ne se poursuit plus bas (%1)&#xa0;: choisissez la racine d’une tige</translation>
    </message>
    <message>
        <source>Stick %1 to the points</source>
        <translation>Coller aux points&#xa0;: %1</translation>
    </message>
    <message>
        <source>Stick the subtree of %1 to the points</source>
        <translation>Coller le sous-arbre aux points&#xa0;: %1</translation>
    </message>
    <message>
        <source>Center %1</source>
        <translation>Centrer&#xa0;: %1</translation>
    </message>
    <message>
        <source>the points around %1 show no middle: move it by hand</source>
        <translation>les points alentour ne montrent aucun milieu (%1)&#xa0;: déplacez à la main</translation>
    </message>
    <message>
        <source>Take the mark off %1</source>
        <translation>Ôter la marque&#xa0;: %1</translation>
    </message>
    <message>
        <source>Mark a unit start at %1</source>
        <translation>Marquer un début d’unité&#xa0;: %1</translation>
    </message>
    <message>
        <source>Mark Unit Start</source>
        <translation>Marquer un début d’unité</translation>
    </message>
    <message>
        <source>A unit of a coarser scale is to start here; once more takes the mark off</source>
        <translation>Une unité d’échelle plus grossière doit commencer ici&#xa0;; une seconde fois ôte la marque</translation>
    </message>
    <message>
        <source>Remove Node</source>
        <translation>Supprimer le nœud</translation>
    </message>
    <message>
        <source>Its children are attached to its parent</source>
        <translation>Ses enfants sont attachés à son parent</translation>
    </message>
    <message>
        <source>Remove Subtree</source>
        <translation>Supprimer le sous-arbre</translation>
    </message>
    <message>
        <source>With all that the node carries</source>
        <translation>Avec tout ce que porte le nœud</translation>
    </message>
    <message>
        <source>node %1</source>
        <translation>nœud %1</translation>
    </message>
    <message>
        <source>New Child</source>
        <translation>Nouvel enfant</translation>
    </message>
    <message>
        <source>Adds a child, on the points ahead</source>
        <translation>Ajoute un enfant, sur les points devant</translation>
    </message>
    <message>
        <source>Extend Again</source>
        <translation>Prolonger encore</translation>
    </message>
    <message>
        <source>One more child of the node that was added last, or is selected</source>
        <translation>Un enfant de plus au dernier nœud ajouté, ou au nœud sélectionné</translation>
    </message>
    <message>
        <source>Extend Foot</source>
        <translation>Prolonger le pied</translation>
    </message>
    <message>
        <source>Moves the root down along its stem, as far as its points go</source>
        <translation>Descend la racine le long de sa tige, aussi loin que vont ses points</translation>
    </message>
    <message>
        <source>Split Edge</source>
        <translation>Scinder l’arête</translation>
    </message>
    <message>
        <source>Puts a node on the edge: where the pointer is, or in the middle</source>
        <translation>Met un nœud sur l’arête&#xa0;: sous le pointeur, ou au milieu</translation>
    </message>
    <message>
        <source>Make Axial</source>
        <translation>Passer en axe</translation>
    </message>
    <message>
        <source>Continues the axis of the parent (&lt;)</source>
        <translation>Poursuit l’axe du parent (&lt;)</translation>
    </message>
    <message>
        <source>Make Branching</source>
        <translation>Passer en ramification</translation>
    </message>
    <message>
        <source>Begins an axis of its own (+)</source>
        <translation>Commence un axe à lui (+)</translation>
    </message>
    <message>
        <source>Stick to Points</source>
        <translation>Coller aux points</translation>
    </message>
    <message>
        <source>Moves the node to the middle of its 5 nearest points</source>
        <translation>Déplace le nœud au milieu de ses 5 points les plus proches</translation>
    </message>
    <message>
        <source>Stick Subtree to Points</source>
        <translation>Coller le sous-arbre aux points</translation>
    </message>
    <message>
        <source>The same for all that the node carries</source>
        <translation>De même pour tout ce que porte le nœud</translation>
    </message>
    <message>
        <source>Move to Section Center</source>
        <translation>Déplacer au centre de la section</translation>
    </message>
    <message>
        <source>Moves the node to the middle of the points around it, of a circle where they show one</source>
        <translation>Déplace le nœud au milieu des points qui l’entourent, d’un cercle s’ils en montrent un</translation>
    </message>
    <message>
        <source>Increase Radius</source>
        <translation>Augmenter le rayon</translation>
    </message>
    <message>
        <source>5 % more</source>
        <translation>5 % de plus</translation>
    </message>
    <message>
        <source>Increase the radius of %1</source>
        <translation>Augmenter le rayon&#xa0;: %1</translation>
    </message>
    <message>
        <source>Decrease Radius</source>
        <translation>Diminuer le rayon</translation>
    </message>
    <message>
        <source>5 % less</source>
        <translation>5 % de moins</translation>
    </message>
    <message>
        <source>Decrease the radius of %1</source>
        <translation>Diminuer le rayon&#xa0;: %1</translation>
    </message>
    <message>
        <source>Change the radius of %1</source>
        <translation>Modifier le rayon&#xa0;: %1</translation>
    </message>
    <message>
        <source>Set the radius of %1</source>
        <translation>Définir le rayon&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 nodes</source>
        <translation>%1 nœuds</translation>
    </message>
    <message>
        <source>the points around %1 show no middle: move them by hand</source>
        <translation>les points autour de %1 ne montrent pas de milieu&#xa0;: déplacez-les à la main</translation>
    </message>
    <message>
        <source>the points end here: New Child adds a node all the same</source>
        <translation>les points s’arrêtent ici&#xa0;: «&#xa0;Nouvel enfant&#xa0;» ajoute quand même un nœud</translation>
    </message>
</context>
<context>
    <name>NodeTable</name>
    <message>
        <source>Node</source>
        <translation>Nœud</translation>
    </message>
    <message>
        <source>Parent</source>
        <translation>Parent</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Arête</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordre</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Classe</translation>
    </message>
    <message>
        <source>Index</source>
        <translation>Indice</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Marque</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Révision</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Commentaire</translation>
    </message>
    <message>
        <source>Radius from</source>
        <translation>Source du rayon</translation>
    </message>
    <message>
        <source>At least</source>
        <translation>Au moins</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Au plus</translation>
    </message>
    <message>
        <source>reviewed</source>
        <translation>révisé</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>douteux</translation>
    </message>
    <message>
        <source>to do</source>
        <translation>à faire</translation>
    </message>
    <message>
        <source>unit start</source>
        <translation>début d’unité</translation>
    </message>
    <message>
        <source>there is no column “%1”: the columns are %2</source>
        <translation>il n’y a pas de colonne «&#xa0;%1&#xa0;»&#xa0;: les colonnes sont %2</translation>
    </message>
    <message>
        <source>%1 is compared with a number, as in “%1 &gt; 10”</source>
        <translation>%1 se compare à un nombre, comme dans «&#xa0;%1 &gt; 10&#xa0;»</translation>
    </message>
    <message>
        <source>%1 is a text: compare it by = or !=</source>
        <translation>%1 est un texte&#xa0;: comparez-le par = ou !=</translation>
    </message>
    <message>
        <source>and</source>
        <comment>between two conditions</comment>
        <translation>et</translation>
    </message>
</context>
<context>
    <name>OptionsText</name>
    <message>
        <source>Up: %1</source>
        <translation>Haut&#xa0;: %1</translation>
    </message>
    <message>
        <source>Root: picked</source>
        <translation>Racine&#xa0;: choisie</translation>
    </message>
    <message>
        <source>Root: lowest point</source>
        <translation>Racine&#xa0;: point le plus bas</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Backspace</source>
        <translation>Retour arrière</translation>
    </message>
</context>
<context>
    <name>RadiusText</name>
    <message>
        <source>extrapolated</source>
        <translation>extrapolé</translation>
    </message>
    <message>
        <source>corrected</source>
        <translation>corrigé</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>mesuré</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>à la main</translation>
    </message>
    <message>
        <source>%1, %2 to %3</source>
        <translation>%1, %2 à %3</translation>
    </message>
</context>
<context>
    <name>ReferenceText</name>
    <message>
        <source>the reference in this project cannot be read: load it from its file</source>
        <translation>la référence de ce projet ne peut pas être lue&#xa0;: chargez-la depuis son fichier</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>within</source>
        <translation>à moins de</translation>
    </message>
    <message>
        <source>How far from one to the other, over the length</source>
        <translation>Distance de l’une à l’autre, sur toute la longueur</translation>
    </message>
    <message>
        <source>from</source>
        <translation>de</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>moyenne</translation>
    </message>
    <message>
        <source>95 % within</source>
        <translation>95 % à moins de</translation>
    </message>
    <message>
        <source>over %1 off</source>
        <translation>à plus de %1</translation>
    </message>
    <message>
        <source>mean of these</source>
        <translation>moyenne de ceux-ci</translation>
    </message>
    <message>
        <source>the plant to the reference</source>
        <translation>la plante à la référence</translation>
    </message>
    <message>
        <source>the reference to the plant</source>
        <translation>la référence à la plante</translation>
    </message>
    <message>
        <source>index</source>
        <translation>indice</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valeur</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>intervalle à 95 %</translation>
    </message>
    <message>
        <source>length precision</source>
        <translation>précision en longueur</translation>
    </message>
    <message>
        <source>length recall</source>
        <translation>rappel en longueur</translation>
    </message>
    <message>
        <source>segments matched</source>
        <translation>segments appariés</translation>
    </message>
    <message>
        <source>segments of the plant</source>
        <translation>segments de la plante</translation>
    </message>
    <message>
        <source>segments of the reference</source>
        <translation>segments de la référence</translation>
    </message>
    <message>
        <source>cost of the matching</source>
        <translation>coût de l’appariement</translation>
    </message>
    <message>
        <source>As the authors of the method measure</source>
        <translation>Comme les auteurs de la méthode mesurent</translation>
    </message>
    <message>
        <source>edits: removed, inserted</source>
        <translation>édition&#xa0;: supprimés, insérés</translation>
    </message>
    <message>
        <source>Attachment; places count as found within %1</source>
        <translation>Points d’attache&#xa0;; un endroit compte comme trouvé à %1 près</translation>
    </message>
    <message>
        <source>Agreement over the tolerance</source>
        <translation>Accord selon la tolérance</translation>
    </message>
    <message>
        <source>Precision, recall and F over the tolerance; marked at %1</source>
        <translation>Précision, rappel et F selon la tolérance&#xa0;; repère à %1</translation>
    </message>
    <message>
        <source>Indices</source>
        <translation>Indices</translation>
    </message>
    <message>
        <source>Others</source>
        <translation>Autres</translation>
    </message>
    <message>
        <source>precision</source>
        <translation>précision</translation>
    </message>
    <message>
        <source>recall</source>
        <translation>rappel</translation>
    </message>
    <message>
        <source>plant</source>
        <translation>plante</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>référence</translation>
    </message>
    <message>
        <source>Where they agree</source>
        <translation>Là où elles s’accordent</translation>
    </message>
    <message>
        <source>Precision and recall within %1, and the length that each plant has there. A dash: it has none.</source>
        <translation>Précision et rappel à %1 près, et la longueur que chaque plante a à cet endroit. Un tiret&#xa0;: elle n’en a pas.</translation>
    </message>
    <message>
        <source>By height, the top first</source>
        <translation>Par hauteur, le sommet d’abord</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>By order, the trunk first; each by its own orders</source>
        <translation>Par ordre, le tronc d’abord&#xa0;; chacune selon ses propres ordres</translation>
    </message>
    <message>
        <source>order</source>
        <translation>ordre</translation>
    </message>
    <message>
        <source>the seal is of an older program, which kept neither findings nor agreements</source>
        <translation>le sceau vient d’un programme plus ancien, qui ne gardait ni constats ni accords</translation>
    </message>
    <message>
        <source>%1 of %2 nodes were marked as reviewed in bulk</source>
        <translation>%1 nœuds sur %2 ont été marqués en bloc comme révisés</translation>
    </message>
    <message>
        <source>%1 of %2 nodes were reviewed before the plant was opened</source>
        <translation>%1 nœuds sur %2 étaient révisés avant l’ouverture de la plante</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>De face</translation>
    </message>
    <message>
        <source>From the right</source>
        <translation>De droite</translation>
    </message>
    <message>
        <source>The scan</source>
        <translation>Le scan</translation>
    </message>
    <message>
        <source>When it was signed</source>
        <translation>Au moment de la signature</translation>
    </message>
    <message>
        <source>what</source>
        <translation>quoi</translation>
    </message>
    <message>
        <source>how much</source>
        <translation>combien</translation>
    </message>
    <message>
        <source>comment</source>
        <translation>commentaire</translation>
    </message>
    <message>
        <source>by</source>
        <translation>par</translation>
    </message>
    <message>
        <source>nodes</source>
        <translation>nœuds</translation>
    </message>
    <message>
        <source>and %1 more, in the project</source>
        <translation>et %1 de plus, dans le projet</translation>
    </message>
    <message>
        <source>Certificate of a reference</source>
        <translation>Certificat d’une référence</translation>
    </message>
    <message>
        <source>Espalier %1</source>
        <translation>Espalier %1</translation>
    </message>
    <message>
        <source>Signed by %1</source>
        <translation>Signé par %1</translation>
    </message>
    <message>
        <source>The signer has looked at all of this structure, and to their knowledge it is right.</source>
        <translation>Le signataire a regardé toute cette structure et, à sa connaissance, elle est juste.</translation>
    </message>
    <message>
        <source>To the signer&apos;s knowledge this structure is right, also where they did not look closely.</source>
        <translation>À la connaissance du signataire, cette structure est juste, même là où il n’a pas regardé de près.</translation>
    </message>
    <message>
        <source>structure</source>
        <translation>structure</translation>
    </message>
    <message>
        <source>scan</source>
        <translation>scan</translation>
    </message>
    <message>
        <source>There are no pictures: %1</source>
        <translation>Il n’y a pas d’images&#xa0;: %1</translation>
    </message>
    <message>
        <source>number</source>
        <translation>nombre</translation>
    </message>
    <message>
        <source>%1 (in use then)</source>
        <translation>%1 (alors utilisé)</translation>
    </message>
    <message>
        <source>How options were chosen</source>
        <translation>Comment les options ont été choisies</translation>
    </message>
    <message>
        <source>%1, %2.</source>
        <translation>%1, %2.</translation>
    </message>
    <message>
        <source>%1 compared with %2</source>
        <translation>%1 comparée avec %2</translation>
    </message>
    <message>
        <source>lengths in the unit of the files</source>
        <translation>longueurs dans l’unité des fichiers</translation>
    </message>
    <message>
        <source>lengths in %1</source>
        <translation>longueurs en %1</translation>
    </message>
    <message>
        <source>setting</source>
        <translation>réglage</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>%1 about (%2, %3, %4) through its middle</source>
        <translation>%1 autour de (%2, %3, %4) par son milieu</translation>
    </message>
    <message>
        <source>registration</source>
        <translation>recalage</translation>
    </message>
    <message>
        <source>none: compared where they lie</source>
        <translation>aucun&#xa0;: comparées là où elles se trouvent</translation>
    </message>
    <message>
        <source>the plant was moved to lie on the reference</source>
        <translation>la plante a été déplacée pour se poser sur la référence</translation>
    </message>
    <message>
        <source>turns tried about</source>
        <translation>rotations essayées autour de</translation>
    </message>
    <message>
        <source>turn about x, y, z</source>
        <translation>rotation autour de x, y, z</translation>
    </message>
    <message>
        <source>shift x, y, z</source>
        <translation>translation x, y, z</translation>
    </message>
    <message>
        <source>shift in all</source>
        <translation>translation totale</translation>
    </message>
    <message>
        <source>mean distance before, after</source>
        <translation>distance moyenne avant, après</translation>
    </message>
    <message>
        <source>counted up to</source>
        <translation>comptée jusqu’à</translation>
    </message>
    <message>
        <source>length of both within %1</source>
        <translation>longueur des deux à moins de %1</translation>
    </message>
    <message>
        <source>unit of lengths</source>
        <translation>unité des longueurs</translation>
    </message>
    <message>
        <source>that of the files</source>
        <translation>celle des fichiers</translation>
    </message>
    <message>
        <source>scale of the plant</source>
        <translation>échelle de la plante</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>tolérance</translation>
    </message>
    <message>
        <source>distances of the table</source>
        <translation>distances du tableau</translation>
    </message>
    <message>
        <source>step between samples</source>
        <translation>pas entre les échantillons</translation>
    </message>
    <message>
        <source>segments are candidates up to</source>
        <translation>segments candidats jusqu’à</translation>
    </message>
    <message>
        <source>tips and branchings pair up to</source>
        <translation>extrémités et ramifications appariées jusqu’à</translation>
    </message>
    <message>
        <source>by height and order within</source>
        <translation>par hauteur et ordre, à moins de</translation>
    </message>
    <message>
        <source>paths along the plant</source>
        <translation>chemins le long de la plante</translation>
    </message>
    <message>
        <source>%1 pairs</source>
        <translation>%1 paires</translation>
    </message>
    <message>
        <source>draws for the intervals</source>
        <translation>tirages pour les intervalles</translation>
    </message>
    <message>
        <source>%1, seed %2</source>
        <translation>%1, graine %2</translation>
    </message>
    <message>
        <source>edit distance of</source>
        <translation>distance d’édition des</translation>
    </message>
    <message>
        <source>%1, cost %2%3</source>
        <translation>%1, coût %2%3</translation>
    </message>
    <message>
        <source>, paths merged</source>
        <translation>, chemins fusionnés</translation>
    </message>
    <message>
        <source>up</source>
        <translation>haut</translation>
    </message>
    <message>
        <source>version</source>
        <translation>version</translation>
    </message>
    <message>
        <source>Espalier %1, Qt %2</source>
        <translation>Espalier %1, Qt %2</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>Intervals</source>
        <translation>Intervalles</translation>
    </message>
    <message>
        <source>The segments of the reference are drawn again with replacement; the middle 95 % of the scores. They show how much depends on which segments this one plant has.</source>
        <translation>Les segments de la référence sont tirés à nouveau avec remise&#xa0;; les 95 % centraux des scores. Ils montrent à quel point le résultat dépend des segments que cette plante-ci possède.</translation>
    </message>
    <message>
        <source>Strahler number</source>
        <translation>Nombre de Strahler</translation>
    </message>
    <message>
        <source>An apex has 1; a node has the greatest number above it, and one more where several have that.</source>
        <translation>Un apex a 1&#xa0;; un nœud a le plus grand nombre au-dessus de lui, et un de plus si plusieurs l’ont.</translation>
    </message>
    <message>
        <source>Crown and angles</source>
        <translation>Houppier et angles</translation>
    </message>
    <message>
        <source>The crown is all that branches from the trunk, its area that of its convex hull seen from above. Divergence is the angle around the axis from one branch to the next.</source>
        <translation>Le houppier est tout ce qui part du tronc, son aire celle de son enveloppe convexe vue d’en haut. La divergence est l’angle autour de l’axe d’une branche à la suivante.</translation>
    </message>
    <message>
        <source>Quantities as in PlantScan3D.</source>
        <translation>Grandeurs comme dans PlantScan3D.</translation>
    </message>
    <message>
        <source>STAR</source>
        <translation>STAR</translation>
    </message>
    <message>
        <source>Silhouette to total area of the surface from 46 directions, weighted by the standard overcast sky.</source>
        <translation>Rapport de la silhouette à l’aire totale de la surface depuis 46 directions, pondéré par le ciel couvert standard.</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Entrées</translation>
    </message>
    <message>
        <source>role</source>
        <translation>rôle</translation>
    </message>
    <message>
        <source>file</source>
        <translation>fichier</translation>
    </message>
    <message>
        <source>SHA-256</source>
        <translation>SHA-256</translation>
    </message>
    <message>
        <source>Export the plant as %1 first.</source>
        <translation>Exportez d’abord la plante sous le nom %1.</translation>
    </message>
    <message>
        <source>How it was measured</source>
        <translation>Comment la mesure a été faite</translation>
    </message>
    <message>
        <source>All numbers as JSON and CSV; they are the values that this report rounds:</source>
        <translation>Tous les nombres en JSON et CSV&#xa0;; ce sont les valeurs que ce rapport arrondit&#xa0;:</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>Méthodes</translation>
    </message>
    <message>
        <source>1 %1</source>
        <translation>1 %1</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>The plant is %1 high. It has %2 of a length of %3 in sum, in %4, with %5 and %6.</source>
        <translation>La plante a une hauteur de %1. Elle compte %2 d’une longueur totale de %3, en %4, avec %5 et %6.</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>axe</translation>
    </message>
    <message>
        <source>axes</source>
        <translation>axes</translation>
    </message>
    <message>
        <source>orders</source>
        <translation>ordres</translation>
    </message>
    <message>
        <source>tip</source>
        <translation>extrémité</translation>
    </message>
    <message>
        <source>tips</source>
        <translation>extrémités</translation>
    </message>
    <message>
        <source>branching</source>
        <translation>ramification</translation>
    </message>
    <message>
        <source>branchings</source>
        <translation>ramifications</translation>
    </message>
    <message>
        <source>height</source>
        <translation>hauteur</translation>
    </message>
    <message>
        <source>length of all axes</source>
        <translation>longueur de tous les axes</translation>
    </message>
    <message>
        <source>%1 to %2 in 90 of 100 cases, as radii err</source>
        <translation>%1 à %2 dans 90 cas sur 100, vu l’erreur des rayons</translation>
    </message>
    <message>
        <source>volume of wood</source>
        <translation>volume du bois</translation>
    </message>
    <message>
        <source>under an overcast sky</source>
        <translation>sous un ciel couvert</translation>
    </message>
    <message>
        <source>Summary</source>
        <translation>Résumé</translation>
    </message>
    <message>
        <source>there are no pictures: %1</source>
        <translation>il n’y a pas d’images&#xa0;: %1</translation>
    </message>
    <message>
        <source>The plant</source>
        <translation>La plante</translation>
    </message>
    <message>
        <source>The same from the side</source>
        <translation>La même de côté</translation>
    </message>
    <message>
        <source>points of the plant</source>
        <translation>points de la plante</translation>
    </message>
    <message>
        <source>Axes by order: how many, and their means: along them, straight, where on what bears them, and radii</source>
        <translation>Axes par ordre&#xa0;: combien, et leurs moyennes&#xa0;: le long d’eux, en ligne droite, où sur ce qui les porte, et rayons</translation>
    </message>
    <message>
        <source>length</source>
        <translation>longueur</translation>
    </message>
    <message>
        <source>chord</source>
        <translation>corde</translation>
    </message>
    <message>
        <source>leaves at</source>
        <translation>insertion à</translation>
    </message>
    <message>
        <source>at the base</source>
        <translation>à la base</translation>
    </message>
    <message>
        <source>at the apex</source>
        <translation>à l’apex</translation>
    </message>
    <message>
        <source>Streams by Strahler number</source>
        <translation>Cours par nombre de Strahler</translation>
    </message>
    <message>
        <source>streams</source>
        <translation>cours</translation>
    </message>
    <message>
        <source>length in all</source>
        <translation>longueur totale</translation>
    </message>
    <message>
        <source>Architecture</source>
        <translation>Architecture</translation>
    </message>
    <message>
        <source>trait</source>
        <translation>trait</translation>
    </message>
    <message>
        <source>By order</source>
        <translation>Par ordre</translation>
    </message>
    <message>
        <source>By diameter</source>
        <translation>Par diamètre</translation>
    </message>
    <message>
        <source>up to</source>
        <translation>jusqu’à</translation>
    </message>
    <message>
        <source>By class, scale %1</source>
        <translation>Par classe, échelle %1</translation>
    </message>
    <message>
        <source>class</source>
        <translation>classe</translation>
    </message>
    <message>
        <source>area</source>
        <translation>aire</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>volume</translation>
    </message>
    <message>
        <source>biomass [kg]</source>
        <translation>biomasse [kg]</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>Bois</translation>
    </message>
    <message>
        <source>Edges count as truncated cones; those without a radius have a length alone.</source>
        <translation>Les arêtes comptent comme des troncs de cône&#xa0;; celles sans rayon n’ont qu’une longueur.</translation>
    </message>
    <message>
        <source>Biomass is the volume times a density of %1 kg/m³, which was given.</source>
        <translation>La biomasse est le volume multiplié par la densité donnée de %1 kg/m³.</translation>
    </message>
    <message>
        <source>more</source>
        <translation>plus</translation>
    </message>
    <message>
        <source>all</source>
        <translation>total</translation>
    </message>
    <message>
        <source>Diameter of the stem at breast height, 1.3 m: %1.</source>
        <translation>Diamètre de la tige à hauteur de poitrine, 1.3 m&#xa0;: %1.</translation>
    </message>
    <message>
        <source>There is no diameter of the stem at breast height, 1.3 m: %1.</source>
        <translation>Il n’y a pas de diamètre de la tige à hauteur de poitrine, 1.3 m&#xa0;: %1.</translation>
    </message>
    <message>
        <source>the skeleton</source>
        <translation>le squelette</translation>
    </message>
    <message>
        <source>the points</source>
        <translation>les points</translation>
    </message>
    <message>
        <source>%1 about %2; handles of it were dragged by hand.</source>
        <translation>%1 entourant %2&#xa0;; des poignées ont été déplacées à la main.</translation>
    </message>
    <message>
        <source>%1 about %2.</source>
        <translation>%1 entourant %2.</translation>
    </message>
    <message>
        <source>Crown envelope</source>
        <translation>Enveloppe du houppier</translation>
    </message>
    <message>
        <source>envelope</source>
        <translation>enveloppe</translation>
    </message>
    <message>
        <source>crown diameter</source>
        <translation>diamètre du houppier</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Lumière</translation>
    </message>
    <message>
        <source>The plant shows %1 of its surface to an overcast sky (STAR); a sphere shows 0.25.</source>
        <translation>La plante montre %1 de sa surface à un ciel couvert (STAR)&#xa0;; une sphère en montre 0.25.</translation>
    </message>
    <message>
        <source>The same from pictures of fewer pixels: how far the number may be trusted</source>
        <translation>De même sur des images de moins de pixels&#xa0;: jusqu’où le nombre est fiable</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>pixels</translation>
    </message>
    <message>
        <source>From each direction</source>
        <translation>Depuis chaque direction</translation>
    </message>
    <message>
        <source>elevation</source>
        <translation>élévation</translation>
    </message>
    <message>
        <source>azimuth</source>
        <translation>azimut</translation>
    </message>
    <message>
        <source>weight</source>
        <translation>poids</translation>
    </message>
    <message>
        <source>silhouette</source>
        <translation>silhouette</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>différence</translation>
    </message>
    <message>
        <source>Axes by order</source>
        <translation>Axes par ordre</translation>
    </message>
    <message>
        <source>Silhouette to total area (STAR) under an overcast sky</source>
        <translation>Rapport de la silhouette à l’aire totale (STAR) sous un ciel couvert</translation>
    </message>
    <message>
        <source>Each plant by itself</source>
        <translation>Chaque plante pour elle-même</translation>
    </message>
    <message>
        <source>Means of axes: along them, straight, and where on what bears them</source>
        <translation>Moyennes des axes&#xa0;: le long d’eux, en ligne droite, et où sur ce qui les porte</translation>
    </message>
    <message>
        <source>Mean radii of axes</source>
        <translation>Rayons moyens des axes</translation>
    </message>
    <message>
        <source>correction</source>
        <translation>correction</translation>
    </message>
    <message>
        <source>added</source>
        <translation>ajoutés</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>supprimés</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>déplacés</translation>
    </message>
    <message>
        <source>attached elsewhere</source>
        <translation>attachés ailleurs</translation>
    </message>
    <message>
        <source>another type of edge</source>
        <translation>autre type d’arête</translation>
    </message>
    <message>
        <source>another radius</source>
        <translation>autre rayon</translation>
    </message>
    <message>
        <source>1 edit</source>
        <translation>1 modification</translation>
    </message>
    <message>
        <source>%1 edits</source>
        <translation>%1 modifications</translation>
    </message>
    <message>
        <source>Work by hand</source>
        <translation>Travail à la main</translation>
    </message>
    <message>
        <source>rank</source>
        <translation>rang</translation>
    </message>
    <message>
        <source>interval</source>
        <translation>intervalle</translation>
    </message>
    <message>
        <source>beats the next</source>
        <translation>bat la suivante</translation>
    </message>
    <message>
        <source>Ranking</source>
        <translation>Classement</translation>
    </message>
    <message>
        <source>By %1, within %2.</source>
        <translation>Selon %1, à %2 près.</translation>
    </message>
    <message>
        <source>The segments of the reference were drawn again %1 times, all structures from the same draws. An interval holds the middle %2 of the scores. &quot;Beats the next&quot; is the share of draws in which a structure is above the one after it: near 50 %, the two cannot be distinguished.</source>
        <translation>Les segments de la référence ont été tirés à nouveau %1 fois, toutes les structures sur les mêmes tirages. Un intervalle contient les %2 centraux des scores. «&#xa0;Bat la suivante&#xa0;» est la part des tirages dans lesquels une structure est au-dessus de celle qui la suit&#xa0;: près de 50 %, les deux ne peuvent pas être distinguées.</translation>
    </message>
    <message>
        <source>Scores</source>
        <translation>Scores</translation>
    </message>
    <message>
        <source>What lies near</source>
        <translation>Ce qui est proche</translation>
    </message>
    <message>
        <source>Matched within the distance only</source>
        <translation>Apparié à cette distance seulement</translation>
    </message>
    <message>
        <source>Tips and branchings</source>
        <translation>Extrémités et ramifications</translation>
    </message>
    <message>
        <source>Missed and invented</source>
        <translation>Manqué et inventé</translation>
    </message>
    <message>
        <source>Orders, axes and edges</source>
        <translation>Ordres, axes et arêtes</translation>
    </message>
    <message>
        <source>Edits</source>
        <translation>Édition</translation>
    </message>
    <message>
        <source>Radii</source>
        <translation>Rayons</translation>
    </message>
    <message>
        <source>%1. %2: precision, recall and F</source>
        <translation>%1. %2&#xa0;: précision, rappel et F</translation>
    </message>
    <message>
        <source>shifted by</source>
        <translation>déplacée de</translation>
    </message>
    <message>
        <source>turned by</source>
        <translation>tournée de</translation>
    </message>
    <message>
        <source>each structure was laid on the reference; its row says how far it was turned</source>
        <translation>chaque structure a été posée sur la référence&#xa0;; sa ligne dit de combien elle a été tournée</translation>
    </message>
    <message>
        <source>scale of the structures</source>
        <translation>échelle des structures</translation>
    </message>
    <message>
        <source>%1 structures compared with %2</source>
        <translation>%1 structures comparées avec %2</translation>
    </message>
    <message>
        <source>1 place</source>
        <translation>1 endroit</translation>
    </message>
    <message>
        <source>%1 places</source>
        <translation>%1 endroits</translation>
    </message>
    <message>
        <source>The plant has %1 of the length of the reference within %2, and %3 of its own length lies that near to the reference: F is %4.</source>
        <translation>La plante a %1 de la longueur de la référence à %2 près, et %3 de sa propre longueur se trouve aussi près de la référence&#xa0;: F est %4.</translation>
    </message>
    <message>
        <source>No part of either is missed, invented or wrongly attached.</source>
        <translation>Aucune partie de l’une ou de l’autre n’est manquée, inventée ou mal attachée.</translation>
    </message>
    <message>
        <source>nothing is attached to the wrong wood</source>
        <translation>rien n’est attaché au mauvais bois</translation>
    </message>
    <message>
        <source>1 part is attached to the wrong wood</source>
        <translation>1 partie est attachée au mauvais bois</translation>
    </message>
    <message>
        <source>%1 parts are attached to the wrong wood</source>
        <translation>%1 parties sont attachées au mauvais bois</translation>
    </message>
    <message>
        <source>%1 are missed in %2 and %3 invented in %4; %5.</source>
        <translation>%1 sont manqués en %2 et %3 inventés en %4&#xa0;; %5.</translation>
    </message>
    <message>
        <source>(%1, %2, %3)</source>
        <translation>(%1, %2, %3)</translation>
    </message>
    <message>
        <source>the plant lay %1 off the reference: it was moved by %2 to lie on it</source>
        <translation>la plante se trouvait à %1 de la référence&#xa0;: elle a été déplacée de %2 pour se poser dessus</translation>
    </message>
    <message>
        <source>the plant lay %1 off the reference: it was turned by %2 about (%3, %4, %5) and moved by %6 to lie on it</source>
        <translation>la plante se trouvait à %1 de la référence&#xa0;: elle a été tournée de %2 autour de (%3, %4, %5) et déplacée de %6 pour se poser dessus</translation>
    </message>
    <message>
        <source>Within %1 it agrees best in order %2 (F %3) and least in order %4 (F %5).</source>
        <translation>À %1 près, l’accord est le meilleur à l’ordre %2 (F %3) et le moindre à l’ordre %4 (F %5).</translation>
    </message>
    <message>
        <source>within %1</source>
        <translation>à %1 près</translation>
    </message>
    <message>
        <source>%1 within %2</source>
        <translation>%1 à moins de %2</translation>
    </message>
    <message>
        <source>no.</source>
        <translation>n°</translation>
    </message>
    <message>
        <source>kind</source>
        <translation>genre</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>colored by height, from %1 (violet) to %2 (green)</source>
        <translation>coloré par hauteur, de %1 (violet) à %2 (vert)</translation>
    </message>
    <message>
        <source>all at one height</source>
        <translation>tout à une même hauteur</translation>
    </message>
    <message>
        <source>%1, 1 point, %2</source>
        <translation>%1, 1 point, %2</translation>
    </message>
    <message>
        <source>%1, %2 points, %3</source>
        <translation>%1, %2 points, %3</translation>
    </message>
    <message>
        <source>Under each score, its 95 % interval: the segments of the reference were drawn again %1 times, and the middle 95 % of the scores so found lie there.</source>
        <translation>Sous chaque score, son intervalle à 95 %&#xa0;: les segments de la référence ont été tirés à nouveau %1 fois, et les 95 % centraux des scores ainsi obtenus s’y trouvent.</translation>
    </message>
    <message>
        <source>the plant was multiplied by %1 first</source>
        <translation>la plante a d’abord été multipliée par %1</translation>
    </message>
    <message>
        <source>Both plants</source>
        <translation>Les deux plantes</translation>
    </message>
    <message>
        <source>%1 of the plant</source>
        <translation>%1 de la plante</translation>
    </message>
    <message>
        <source>%1 of the reference, dotted; %2</source>
        <translation>%1 de la référence, en pointillé&#xa0;; %2</translation>
    </message>
    <message>
        <source>%1 of the plant; %2</source>
        <translation>%1 de la plante&#xa0;; %2</translation>
    </message>
    <message>
        <source>What differs, from the front</source>
        <translation>Ce qui diffère, de face</translation>
    </message>
    <message>
        <source>The plant, and what it misses of the reference</source>
        <translation>La plante, et ce qui lui manque de la référence</translation>
    </message>
    <message>
        <source>What differs, from the right</source>
        <translation>Ce qui diffère, de droite</translation>
    </message>
    <message>
        <source>The reference</source>
        <translation>La référence</translation>
    </message>
    <message>
        <source>Largest errors</source>
        <translation>Plus grandes erreurs</translation>
    </message>
    <message>
        <source>There are none at this tolerance.</source>
        <translation>Il n’y en a pas à cette tolérance.</translation>
    </message>
    <message>
        <source>%1 of %2: the longest of each kind. Of what is wrongly attached, all that it carries counts. Rings: where it begins; dashed, where the reference attaches it.</source>
        <translation>%1 sur %2&#xa0;: les plus longues de chaque genre. Pour ce qui est mal attaché, tout ce qu’il porte compte. Anneaux&#xa0;: son départ&#xa0;; en tirets, là où la référence l’attache.</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1 long</source>
        <translation>longueur&#xa0;: %1</translation>
    </message>
    <message>
        <source>Where they begin, in the frame of the reference</source>
        <translation>Où elles commencent, dans le repère de la référence</translation>
    </message>
    <message>
        <source>1 more was looked at and is ignored. All scores and lengths count it.</source>
        <translation>1 de plus a été regardée et est ignorée. Tous les scores et longueurs en tiennent compte.</translation>
    </message>
    <message>
        <source>%1 more were looked at and are ignored. All scores and lengths count them.</source>
        <translation>%1 de plus ont été regardées et sont ignorées. Tous les scores et longueurs en tiennent compte.</translation>
    </message>
    <message>
        <source>Ignored</source>
        <translation>Ignorés</translation>
    </message>
    <message>
        <source>Radii where both lie within %1 of each other</source>
        <translation>Rayons là où les deux sont à moins de %1 l’une de l’autre</translation>
    </message>
    <message>
        <source>measure</source>
        <translation>mesure</translation>
    </message>
    <message>
        <source>length compared</source>
        <translation>longueur comparée</translation>
    </message>
    <message>
        <source>Errors of radii by how much of the circumference has points of the scan</source>
        <translation>Erreurs des rayons selon la part de la circonférence qui a des points du scan</translation>
    </message>
    <message>
        <source>seen</source>
        <translation>vu</translation>
    </message>
    <message>
        <source>compared</source>
        <translation>comparé</translation>
    </message>
    <message>
        <source>mean error</source>
        <translation>erreur moyenne</translation>
    </message>
    <message>
        <source>RMS error</source>
        <translation>erreur quadratique moyenne</translation>
    </message>
    <message>
        <source>of the radius</source>
        <translation>du rayon</translation>
    </message>
    <message>
        <source>%1 to %2 %</source>
        <translation>%1 à %2 %</translation>
    </message>
    <message>
        <source>The diameters of the stems at breast height, 1.3 m, are not compared: %1.</source>
        <translation>Les diamètres des tiges à hauteur de poitrine, 1.3 m, ne sont pas comparés&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Diameter of the stem at breast height, %1 above the foot of the reference</source>
        <translation>Diamètre de la tige à hauteur de poitrine, %1 au-dessus du pied de la référence</translation>
    </message>
    <message>
        <source>Of the plant, and by how much it has more than the reference. Edges count as truncated cones; those without a radius have a length alone.</source>
        <translation>De la plante, et de combien elle dépasse la référence. Les arêtes comptent comme des troncs de cône&#xa0;; celles sans rayon n’ont qu’une longueur.</translation>
    </message>
    <message>
        <source>By radius</source>
        <translation>Par rayon</translation>
    </message>
    <message>
        <source>To know before reading on</source>
        <translation>À savoir avant de lire la suite</translation>
    </message>
    <message>
        <source>findings of the checks that were open: %1 (why they were left is below)</source>
        <translation>constats des contrôles encore ouverts&#xa0;: %1 (la raison est donnée plus bas)</translation>
    </message>
    <message>
        <source>method</source>
        <translation>méthode</translation>
    </message>
    <message>
        <source>What is set other than by default</source>
        <translation>Ce qui n’est pas réglé par défaut</translation>
    </message>
    <message>
        <source>option</source>
        <translation>paramètre</translation>
    </message>
    <message>
        <source>default</source>
        <translation>défaut</translation>
    </message>
    <message>
        <source>How the plant was reconstructed</source>
        <translation>Comment la plante a été reconstruite</translation>
    </message>
    <message>
        <source>By the default methods, all options by their rules.</source>
        <translation>Par les méthodes par défaut, tous les paramètres selon leurs règles.</translation>
    </message>
    <message>
        <source>Points were set aside, or their organs set, by hand: the command knows nothing of that.</source>
        <translation>Des points ont été mis à part, ou leurs organes fixés, à la main&#xa0;: la commande n’en sait rien.</translation>
    </message>
    <message>
        <source>Nothing was corrected by hand since the plant was reconstructed or opened.</source>
        <translation>Rien n’a été corrigé à la main depuis que la plante a été reconstruite ou ouverte.</translation>
    </message>
    <message>
        <source>Since the plant was reconstructed or opened: %1, %2 of work. Pauses of over 5 minutes do not count.</source>
        <translation>Depuis que la plante a été reconstruite ou ouverte&#xa0;: %1, %2 de travail. Les pauses de plus de 5 minutes ne comptent pas.</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <comment>nodes</comment>
        <translation>%1 et %2 autres</translation>
    </message>
    <message>
        <source>at node</source>
        <translation>au nœud</translation>
    </message>
    <message>
        <source>It is about the whole plant, the stem included.</source>
        <translation>Elle entoure toute la plante, tige comprise.</translation>
    </message>
    <message>
        <source>no bounds: how radii err is unknown in %1 of it</source>
        <translation>sans bornes&#xa0;: l’erreur des rayons est inconnue pour %1</translation>
    </message>
    <message>
        <source>from the lowest node to the highest</source>
        <translation>du nœud le plus bas au plus haut</translation>
    </message>
</context>
<context>
    <name>ReportedPlant</name>
    <message>
        <source>plant</source>
        <translation>plante</translation>
    </message>
    <message>
        <source>plant of %1</source>
        <translation>plante de %1</translation>
    </message>
    <message>
        <source>hashed as a node list</source>
        <translation>empreinte calculée sur la liste des nœuds</translation>
    </message>
    <message>
        <source>points of the plant</source>
        <translation>points de la plante</translation>
    </message>
    <message>
        <source>the file can no longer be read</source>
        <translation>le fichier ne peut plus être lu</translation>
    </message>
</context>
<context>
    <name>Review</name>
    <message>
        <source>Reviewed</source>
        <translation>Révisé</translation>
    </message>
    <message>
        <source>Doubtful</source>
        <translation>Douteux</translation>
    </message>
    <message>
        <source>To do</source>
        <translation>À faire</translation>
    </message>
</context>
<context>
    <name>ScanFit</name>
    <message>
        <source>%1 seems to be centered on the mean of the scan: move it by %2?</source>
        <translation>%1 semble centré sur la moyenne du scan&#xa0;: le déplacer de %2&#xa0;?</translation>
    </message>
    <message>
        <source>%1 lies outside of %2: is it of another plant?</source>
        <translation>%1 se trouve hors de %2&#xa0;: est-ce une autre plante&#xa0;?</translation>
    </message>
    <message>
        <source>%1 times as large</source>
        <translation>%1 fois plus grand</translation>
    </message>
    <message>
        <source>%1 times as small</source>
        <translation>%1 fois plus petit</translation>
    </message>
    <message>
        <source>no more than one place</source>
        <translation>réduit à un seul endroit</translation>
    </message>
    <message>
        <source>%1 does not lie on %2: it is %3; is it of another plant, or in another unit?</source>
        <translation>%1 ne se trouve pas sur %2&#xa0;: c’est %3&#xa0;; est-ce une autre plante, ou une autre unité&#xa0;?</translation>
    </message>
</context>
<context>
    <name>ScanLookText</name>
    <message>
        <source>The first three columns are not all numbers: choose below which hold x, y and z.</source>
        <translation>Les trois premières colonnes ne sont pas toutes des nombres&#xa0;: choisissez ci-dessous celles qui contiennent x, y et z.</translation>
    </message>
    <message>
        <source>The first line names the columns, but none x, y and z: check below which they are.</source>
        <translation>La première ligne nomme les colonnes, mais aucune x, y ou z&#xa0;: vérifiez ci-dessous lesquelles le sont.</translation>
    </message>
    <message>
        <source>Columns 4 to 6 could be the color, or columns 5 to 7: check below which they are.</source>
        <translation>La couleur pourrait être dans les colonnes 4 à 6, ou dans les colonnes 5 à 7&#xa0;: vérifiez ci-dessous lesquelles.</translation>
    </message>
    <message>
        <source>Nothing names the columns, and some are left out: check below what they hold.</source>
        <translation>Rien ne nomme les colonnes, et certaines sont écartées&#xa0;: vérifiez ci-dessous ce qu’elles contiennent.</translation>
    </message>
    <message>
        <source>Some lines cannot be read with these columns: choose others below.</source>
        <translation>Certaines lignes ne peuvent pas être lues avec ces colonnes&#xa0;: choisissez-en d’autres ci-dessous.</translation>
    </message>
    <message>
        <source>It has %1 points, more than are read without asking: choose below how many.</source>
        <translation>Il a %1 points, plus que l’on n’en lit sans demander&#xa0;: choisissez ci-dessous combien.</translation>
    </message>
    <message>
        <source>Its unit is not known: choose it below.</source>
        <translation>Son unité n’est pas connue&#xa0;: choisissez-la ci-dessous.</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>environ %1</translation>
    </message>
    <message>
        <source>with intensity and color</source>
        <translation>avec intensité et couleur</translation>
    </message>
    <message>
        <source>with intensity, without color</source>
        <translation>avec intensité, sans couleur</translation>
    </message>
    <message>
        <source>with color, without intensity</source>
        <translation>avec couleur, sans intensité</translation>
    </message>
    <message>
        <source>without intensity and color</source>
        <translation>sans intensité ni couleur</translation>
    </message>
    <message>
        <source>from %1 stations</source>
        <translation>de %1 stations</translation>
    </message>
    <message>
        <source>%1; left out: %2</source>
        <translation>%1&#xa0;; écarté&#xa0;: %2</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 de %2 à %3</translation>
    </message>
    <message>
        <source>%1, of a sample</source>
        <translation>%1, d’un échantillon</translation>
    </message>
    <message>
        <source>%1, which is %2</source>
        <translation>%1, soit %2</translation>
    </message>
    <message>
        <source>Stated: %1</source>
        <translation>Indiqué&#xa0;: %1</translation>
    </message>
    <message>
        <source>Not known: %1</source>
        <translation>Inconnu&#xa0;: %1</translation>
    </message>
    <message>
        <source>Guessed: %1</source>
        <translation>Deviné&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>ScanPart</name>
    <message>
        <source>which part of the scan the plant is of cannot be read: open the scan again</source>
        <translation>la partie du scan dont vient la plante ne peut pas être lue&#xa0;: ouvrez à nouveau le scan</translation>
    </message>
</context>
<context>
    <name>ScoreGroups</name>
    <message>
        <source>Near each other</source>
        <translation>Proches l’un de l’autre</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segments</translation>
    </message>
    <message>
        <source>Attachment</source>
        <translation>Point d’attache</translation>
    </message>
    <message>
        <source>Edits</source>
        <translation>Édition</translation>
    </message>
    <message>
        <source>Radii</source>
        <translation>Rayons</translation>
    </message>
    <message>
        <source>As they were</source>
        <translation>Tels qu’ils étaient</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>95 % interval: %1 to %2, from drawing segments of the reference again and again</source>
        <translation>Intervalle à 95&#xa0;%&#xa0;: de %1 à %2, en tirant et retirant au sort les segments de la référence</translation>
    </message>
</context>
<context>
    <name>Seal</name>
    <message>
        <source>%1 nodes, %2</source>
        <translation>%1 nœuds, %2</translation>
    </message>
    <message>
        <source>F %1 within %2 (precision %3, recall %4), T %5</source>
        <translation>F %1 à %2 près (précision %3, rappel %4), T %5</translation>
    </message>
    <message>
        <source>%1 of %2 (%3 %)</source>
        <translation>%1 sur %2 (%3 %)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>none is open</source>
        <translation>aucun n’est ouvert</translation>
    </message>
    <message>
        <source>%1 open (%2)</source>
        <translation>ouverts&#xa0;: %1 (%2)</translation>
    </message>
    <message>
        <source>; %1 ignored</source>
        <translation>&#xa0;; ignorés&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Structure</translation>
    </message>
    <message>
        <source>At work</source>
        <translation>Au travail</translation>
    </message>
    <message>
        <source>%1, pauses over %2 min left out</source>
        <translation>%1, pauses de plus de %2 min non comprises</translation>
    </message>
    <message>
        <source>Corrections</source>
        <translation>Corrections</translation>
    </message>
    <message>
        <source>Looked at</source>
        <translation>Regardé</translation>
    </message>
    <message>
        <source>Marked in bulk</source>
        <translation>Marqué en bloc</translation>
    </message>
    <message>
        <source>Marked before it was opened</source>
        <translation>Marqué avant l’ouverture</translation>
    </message>
    <message>
        <source>Doubtful before</source>
        <translation>Douteux auparavant</translation>
    </message>
    <message>
        <source>Places with a comment</source>
        <translation>Endroits avec un commentaire</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Constats</translation>
    </message>
    <message>
        <source>Why they are left</source>
        <translation>Pourquoi ils restent</translation>
    </message>
    <message>
        <source>Points without wood</source>
        <translation>Points sans bois</translation>
    </message>
    <message>
        <source>Agreement with %1</source>
        <translation>Accord avec %1</translation>
    </message>
    <message>
        <source>the reconstruction</source>
        <translation>la reconstruction</translation>
    </message>
    <message>
        <source>what was opened</source>
        <translation>ce qui a été ouvert</translation>
    </message>
    <message>
        <source>; at 1 place ignored as no wood: %1 (%2 %)</source>
        <translation>&#xa0;; à 1 endroit ignoré car sans bois&#xa0;: %1 (%2&#xa0;%)</translation>
    </message>
    <message>
        <source>; at %1 places ignored as no wood: %2 (%3 %)</source>
        <translation>&#xa0;; à %1 endroits ignorés car sans bois&#xa0;: %2 (%3&#xa0;%)</translation>
    </message>
    <message>
        <source>%1 answered, %2 open</source>
        <translation>répondues&#xa0;: %1, ouvertes&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 answered</source>
        <translation>répondues&#xa0;: %1</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Questions</translation>
    </message>
    <message>
        <source>1 node, %1</source>
        <translation>1 nœud, %1</translation>
    </message>
</context>
<context>
    <name>Sessions</name>
    <message>
        <source>today</source>
        <translation>aujourd’hui</translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation>hier</translation>
    </message>
    <message>
        <source>1 edit</source>
        <translation>1 modification</translation>
    </message>
    <message>
        <source>%1 edits</source>
        <translation>%1 modifications</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 dans %2</translation>
    </message>
    <message>
        <source>what was decided, no edits</source>
        <translation>ce qui a été décidé, aucune modification</translation>
    </message>
</context>
<context>
    <name>SightKey</name>
    <message>
        <source>Points its new place is from</source>
        <translation>Points dont vient sa nouvelle place</translation>
    </message>
    <message>
        <source>Where it goes</source>
        <translation>Où il va</translation>
    </message>
    <message>
        <source>Neighbors, and the circle through them</source>
        <translation>Voisins, et le cercle qui passe par eux</translation>
    </message>
    <message>
        <source>Neighbors</source>
        <translation>Voisins</translation>
    </message>
    <message>
        <source>Direction of the wood</source>
        <translation>Direction du bois</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Cones of the search</source>
        <translation>Cônes de la recherche</translation>
    </message>
</context>
<context>
    <name>StructureEdits</name>
    <message>
        <source>Swap the continuation of %1</source>
        <translation>Échanger la continuation&#xa0;: %1</translation>
    </message>
    <message>
        <source>Cut off %1</source>
        <translation>Couper&#xa0;: %1</translation>
    </message>
    <message>
        <source>Join %1 to %2</source>
        <translation>Joindre&#xa0;: %1 à %2</translation>
    </message>
    <message>
        <source>%1 is the root already</source>
        <translation>%1 est déjà la racine</translation>
    </message>
    <message>
        <source>Make %1 the root</source>
        <translation>Prendre comme racine&#xa0;: %1</translation>
    </message>
    <message>
        <source>Merge %1</source>
        <translation>Fusionner&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 is alone on its axis: select the two ends of a path</source>
        <translation>%1 est seul sur son axe&#xa0;: sélectionnez les deux extrémités d’un chemin</translation>
    </message>
    <message>
        <source>Turn around the path of %1</source>
        <translation>Retourner le chemin&#xa0;: %1</translation>
    </message>
    <message>
        <source>the plant has no edge to smooth along</source>
        <translation>la plante n’a pas d’arête le long de laquelle lisser</translation>
    </message>
    <message>
        <source>Smooth %1</source>
        <translation>Lisser&#xa0;: %1</translation>
    </message>
    <message>
        <source>there is no edge between the ends</source>
        <translation>il n’y a pas d’arête entre les extrémités</translation>
    </message>
    <message>
        <source>&amp;Tree</source>
        <translation>&amp;Arbre</translation>
    </message>
    <message>
        <source>Cut Off</source>
        <translation>Couper</translation>
    </message>
    <message>
        <source>What the node carries becomes a tree of its own</source>
        <translation>Ce que porte le nœud devient un arbre à part</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Joindre</translation>
    </message>
    <message>
        <source>Attaches the tree of the node to the nearest other, or to the last node selected</source>
        <translation>Attache l’arbre du nœud au plus proche, ou au dernier nœud sélectionné</translation>
    </message>
    <message>
        <source>Swap Continuation</source>
        <translation>Échanger la continuation</translation>
    </message>
    <message>
        <source>Another child continues the axis of the node</source>
        <translation>Un autre enfant poursuit l’axe du nœud</translation>
    </message>
    <message>
        <source>Merge Nodes</source>
        <translation>Fusionner les nœuds</translation>
    </message>
    <message>
        <source>Makes one node of several neighbors</source>
        <translation>Fait un seul nœud de plusieurs voisins</translation>
    </message>
    <message>
        <source>Make Root</source>
        <translation>Faire racine</translation>
    </message>
    <message>
        <source>The tree grows from this node</source>
        <translation>L’arbre pousse depuis ce nœud</translation>
    </message>
    <message>
        <source>Turn Around</source>
        <translation>Retourner</translation>
    </message>
    <message>
        <source>The path is attached by its other end</source>
        <translation>Le chemin est attaché par son autre extrémité</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>Redresser</translation>
    </message>
    <message>
        <source>Puts the nodes between the ends on a straight line</source>
        <translation>Met les nœuds entre les extrémités sur une ligne droite</translation>
    </message>
    <message>
        <source>Straighten the path of %1</source>
        <translation>Redresser le chemin&#xa0;: %1</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Lisser</translation>
    </message>
    <message>
        <source>Moves the selected nodes, or those between two, to the mean of their neighbors</source>
        <translation>Déplace les nœuds sélectionnés, ou ceux entre deux, vers la moyenne de leurs voisins</translation>
    </message>
    <message>
        <source>Interpolate Radii</source>
        <translation>Interpoler les rayons</translation>
    </message>
    <message>
        <source>Radii between the ends follow from those of the ends</source>
        <translation>Les rayons entre les extrémités suivent de ceux des extrémités</translation>
    </message>
    <message>
        <source>Interpolate the radii of the path of %1</source>
        <translation>Interpoler les rayons du chemin&#xa0;: %1</translation>
    </message>
    <message>
        <source>Thin Out</source>
        <translation>Éclaircir</translation>
    </message>
    <message>
        <source>Removes nodes between the ends; attachments stay</source>
        <translation>Supprime des nœuds entre les extrémités&#xa0;; les points d’attache restent</translation>
    </message>
    <message>
        <source>Thin out the path of %1</source>
        <translation>Éclaircir le chemin&#xa0;: %1</translation>
    </message>
    <message>
        <source>Space Evenly</source>
        <translation>Espacer également</translation>
    </message>
    <message>
        <source>Moves the nodes to equal distances</source>
        <translation>Déplace les nœuds à des distances égales</translation>
    </message>
    <message>
        <source>More Nodes</source>
        <translation>Plus de nœuds</translation>
    </message>
    <message>
        <source>Twice as many nodes, evenly spaced</source>
        <translation>Deux fois plus de nœuds, également espacés</translation>
    </message>
    <message>
        <source>Fewer Nodes</source>
        <translation>Moins de nœuds</translation>
    </message>
    <message>
        <source>Half as many nodes, evenly spaced</source>
        <translation>Deux fois moins de nœuds, également espacés</translation>
    </message>
    <message>
        <source>&amp;Path</source>
        <translation>Che&amp;min</translation>
    </message>
    <message>
        <source>Space the path of %1</source>
        <translation>Espacer le chemin&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>SweepScores</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur&#xa0;%2</translation>
    </message>
    <message>
        <source>No star: it is best at an end of the values, to which it leads by itself.</source>
        <translation>Pas d’étoile&#xa0;: le meilleur se trouve à un bout des valeurs, où il mène de lui-même.</translation>
    </message>
</context>
<context>
    <name>ThingGesture</name>
    <message>
        <source>Click a pole: selects its points</source>
        <translation>Cliquer un poteau&#xa0;: sélectionne ses points</translation>
    </message>
    <message>
        <source>Click the wire at its other end   Esc: leave it</source>
        <translation>Cliquer l’autre bout du câble   Échap&#xa0;: laisser</translation>
    </message>
    <message>
        <source>Click a wire at one end, then at the other: selects its points</source>
        <translation>Cliquer un câble à un bout, puis à l’autre&#xa0;: sélectionne ses points</translation>
    </message>
    <message>
        <source>Click a plant: selects its points</source>
        <translation>Cliquer une plante&#xa0;: sélectionne ses points</translation>
    </message>
    <message>
        <source>there is no point here: click one of the thing to select</source>
        <translation>il n’y a pas de point ici&#xa0;: cliquez-en un de la chose à sélectionner</translation>
    </message>
</context>
<context>
    <name>TolerancePlot</name>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>precision</source>
        <translation>précision</translation>
    </message>
    <message>
        <source>recall</source>
        <translation>rappel</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>tolérance</translation>
    </message>
    <message>
        <source>tolerance [%1]</source>
        <translation>tolérance [%1]</translation>
    </message>
</context>
<context>
    <name>Tools</name>
    <message>
        <source>Select and Move</source>
        <translation>Sélectionner et déplacer</translation>
    </message>
    <message>
        <source>Click to select, drag to move</source>
        <translation>Cliquer pour sélectionner, glisser pour déplacer</translation>
    </message>
    <message>
        <source>Add Nodes</source>
        <translation>Ajouter des nœuds</translation>
    </message>
    <message>
        <source>Pull children out of nodes, insert on edges, click along points</source>
        <translation>Tirer des enfants hors des nœuds, insérer sur les arêtes, cliquer le long des points</translation>
    </message>
    <message>
        <source>Reparent</source>
        <translation>Rattacher</translation>
    </message>
    <message>
        <source>Drag a branch onto another node or edge</source>
        <translation>Glisser une branche sur un autre nœud ou une autre arête</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Tracer</translation>
    </message>
    <message>
        <source>Click a start and an end: the branch is found along the points</source>
        <translation>Cliquer un début et une fin&#xa0;: la branche est trouvée le long des points</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>Tracé à main levée</translation>
    </message>
    <message>
        <source>Draw across edges to cut, along points to branch, around a crossing to exchange arms</source>
        <translation>Tracer en travers des arêtes pour couper, le long des points pour ramifier, autour d’un croisement pour échanger les bras</translation>
    </message>
    <message>
        <source>Regrow</source>
        <translation>Reconstruire à nouveau</translation>
    </message>
    <message>
        <source>What a node carries is reconstructed again from the points</source>
        <translation>Ce que porte un nœud est reconstruit à nouveau à partir des points</translation>
    </message>
    <message>
        <source>Select Points</source>
        <translation>Sélectionner des points</translation>
    </message>
    <message>
        <source>A brush, boxes and lassos select points of the scan, to set them aside</source>
        <translation>Un pinceau, des boîtes et des lassos sélectionnent des points du scan, pour les mettre de côté</translation>
    </message>
    <message>
        <source>Pick Root</source>
        <translation>Choisir la racine</translation>
    </message>
    <message>
        <source>Click the foot of the trunk in the scan: the plant will be rooted there</source>
        <translation>Cliquer le pied du tronc dans le scan&#xa0;: la plante y aura sa racine</translation>
    </message>
    <message>
        <source>Navigate</source>
        <translation>Naviguer</translation>
    </message>
    <message>
        <source>The mouse only moves the camera</source>
        <translation>La souris ne déplace que la caméra</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Mesurer</translation>
    </message>
    <message>
        <source>Click two things for their distance, three for an angle</source>
        <translation>Cliquer deux choses pour leur distance, trois pour un angle</translation>
    </message>
</context>
<context>
    <name>ViewText</name>
    <message>
        <source>the view of this project cannot be read: all of the plant is shown</source>
        <translation>la vue de ce projet ne peut pas être lue&#xa0;: la plante entière est affichée</translation>
    </message>
</context>
<context>
    <name>Worklist</name>
    <message>
        <source>, T %1</source>
        <translation>, T %1</translation>
    </message>
    <message>
        <source>%1 with %2</source>
        <translation>%1 avec %2</translation>
    </message>
    <message>
        <source>Signed by %1</source>
        <translation>Signé par %1</translation>
    </message>
    <message>
        <source>Edited since it was signed by %1</source>
        <translation>Modifié depuis la signature par %1</translation>
    </message>
    <message>
        <source>1 node</source>
        <translation>1 nœud</translation>
    </message>
    <message>
        <source>%1 nodes</source>
        <translation>%1 nœuds</translation>
    </message>
    <message>
        <source>At work: %1</source>
        <translation>Au travail&#xa0;: %1</translation>
    </message>
    <message>
        <source>Agreement: %1</source>
        <translation>Accord&#xa0;: %1</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Lecture…</translation>
    </message>
    <message>
        <source>To do</source>
        <translation>À faire</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>In review, seal broken</source>
        <translation>En révision, sceau rompu</translation>
    </message>
    <message>
        <source>In review</source>
        <translation>En révision</translation>
    </message>
    <message>
        <source>F %1 within %2</source>
        <translation>F %1 à %2 près</translation>
    </message>
</context>
<context>
    <name>espalier::AboutDialog</name>
    <message>
        <source>&lt;b&gt;Espalier %1&lt;/b&gt;&lt;br&gt;From a laser scan of a plant to a skeleton an expert would sign.</source>
        <translation>&lt;b&gt;Espalier %1&lt;/b&gt;&lt;br&gt;Du scan laser d’une plante à un squelette qu’un expert signerait.</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothèque</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>License</source>
        <translation>Licence</translation>
    </message>
    <message>
        <source>Used for</source>
        <translation>Utilisée pour</translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation>Bibliothèques</translation>
    </message>
    <message>
        <source>About Espalier</source>
        <translation>À propos d’Espalier</translation>
    </message>
    <message>
        <source>Copy Versions</source>
        <translation>Copier les versions</translation>
    </message>
    <message>
        <source>Copies what a report of a problem begins with</source>
        <translation>Copie ce par quoi commence un signalement de problème</translation>
    </message>
</context>
<context>
    <name>espalier::AddNodeTool</name>
    <message>
        <source>Taken back. Release the button</source>
        <translation>Retiré. Relâchez le bouton</translation>
    </message>
    <message>
        <source>Release: leave it here   Esc: take it back</source>
        <translation>Relâcher&#xa0;: laisser ici   Échap&#xa0;: retirer</translation>
    </message>
    <message>
        <source>Drag: pull a child out of %1   Click: go on from it</source>
        <translation>Glisser&#xa0;: tirer un enfant (%1)   Cliquer&#xa0;: continuer à partir de lui</translation>
    </message>
    <message>
        <source>Press: insert a node here   Drag: move it</source>
        <translation>Appuyer&#xa0;: insérer un nœud ici   Glisser&#xa0;: le déplacer</translation>
    </message>
    <message>
        <source>Click a point: put the root there</source>
        <translation>Cliquer un point&#xa0;: y mettre la racine</translation>
    </message>
    <message>
        <source>Click: add a child of %1 here   Drag: turn</source>
        <translation>Cliquer&#xa0;: ajouter ici un enfant à %1   Glisser&#xa0;: tourner</translation>
    </message>
    <message>
        <source>Click a point: add a child of %1   Drag: turn</source>
        <translation>Cliquer un point&#xa0;: ajouter un enfant à %1   Glisser&#xa0;: tourner</translation>
    </message>
    <message>
        <source>Click a node: go on from it   Drag a node: pull a child   Press an edge: insert</source>
        <translation>Cliquer un nœud&#xa0;: continuer à partir de lui   Glisser un nœud&#xa0;: tirer un enfant   Appuyer sur une arête&#xa0;: insérer</translation>
    </message>
    <message>
        <source>Insert a node below %1</source>
        <translation>Insérer un nœud sous %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Déplacer&#xa0;: %1</translation>
    </message>
    <message>
        <source>Add a child to %1</source>
        <translation>Ajouter un enfant à %1</translation>
    </message>
    <message>
        <source>no node to go on from: click one first</source>
        <translation>aucun nœud à partir duquel continuer&#xa0;: cliquez-en un d’abord</translation>
    </message>
    <message>
        <source>Add a root</source>
        <translation>Ajouter une racine</translation>
    </message>
</context>
<context>
    <name>espalier::AddValueDialog</name>
    <message>
        <source>Number (REAL)</source>
        <translation>Nombre (REAL)</translation>
    </message>
    <message>
        <source>Whole number (INT)</source>
        <translation>Nombre entier (INT)</translation>
    </message>
    <message>
        <source>Text (%1)</source>
        <translation>Texte (%1)</translation>
    </message>
    <message>
        <source>Date (%1)</source>
        <translation>Date (%1)</translation>
    </message>
    <message>
        <source>such as Length or leaf_area</source>
        <translation>par exemple Length ou leaf_area</translation>
    </message>
    <message>
        <source>Feature</source>
        <translation>Attribut</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Genre</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>such as %1</source>
        <translation>par exemple %1</translation>
    </message>
</context>
<context>
    <name>espalier::AskingFlow</name>
    <message>
        <source>Doubts</source>
        <translation>Doutes</translation>
    </message>
    <message>
        <source>Ask About Doubts</source>
        <translation>Interroger sur les doutes</translation>
    </message>
    <message>
        <source>Goes to what the program is in doubt about, what matters most first, and asks</source>
        <translation>Va à ce dont le programme doute, le plus important d’abord, et pose la question</translation>
    </message>
    <message>
        <source>Answer 1</source>
        <translation>Réponse 1</translation>
    </message>
    <message>
        <source>Answer 2</source>
        <translation>Réponse 2</translation>
    </message>
    <message>
        <source>Answer 3</source>
        <translation>Réponse 3</translation>
    </message>
    <message>
        <source>Answer 4</source>
        <translation>Réponse 4</translation>
    </message>
    <message>
        <source>Takes the alternative with this number</source>
        <translation>Prend la possibilité qui porte ce numéro</translation>
    </message>
    <message>
        <source>None of These</source>
        <translation>Aucune d’elles</translation>
    </message>
    <message>
        <source>No alternative is right: marks the wood doubtful, to be corrected by hand</source>
        <translation>Aucune possibilité n’est juste&#xa0;: marque le bois comme douteux, à corriger à la main</translation>
    </message>
    <message>
        <source>Skip Doubt</source>
        <translation>Passer ce doute</translation>
    </message>
    <message>
        <source>Goes on; it is asked again after all others</source>
        <translation>Continue&#xa0;; la question revient après toutes les autres</translation>
    </message>
    <message>
        <source>Take Back Answer</source>
        <translation>Reprendre la réponse</translation>
    </message>
    <message>
        <source>Takes the last answer back, and asks again</source>
        <translation>Reprend la dernière réponse, et pose à nouveau la question</translation>
    </message>
    <message>
        <source>Stop Asking</source>
        <translation>Arrêter les questions</translation>
    </message>
    <message>
        <source>Goes on without questions</source>
        <translation>Continue sans questions</translation>
    </message>
    <message>
        <source>Decide the Rest by Odds</source>
        <translation>Décider du reste</translation>
    </message>
    <message>
        <source>Shows what the odds, as answers have taught, would change; once more makes it, as one step</source>
        <translation>Montre ce que changeraient les probabilités, telles que les réponses les ont instruites&#xa0;; une seconde fois l’applique, en une étape</translation>
    </message>
    <message>
        <source>doubts follow from the points: open a scan first</source>
        <translation>les doutes viennent des points&#xa0;: ouvrez d’abord un scan</translation>
    </message>
    <message>
        <source>Nothing is in doubt</source>
        <translation>Rien n’est en doute</translation>
    </message>
    <message>
        <source>Looking for doubts…</source>
        <translation>Recherche de doutes…</translation>
    </message>
    <message>
        <source>The odds would change nothing of what is left</source>
        <translation>Les probabilités ne changeraient rien à ce qui reste</translation>
    </message>
    <message>
        <source>1 place is decided by its odds</source>
        <translation>1 endroit est décidé par ses probabilités</translation>
    </message>
    <message>
        <source>%1 places are decided by their odds</source>
        <translation>%1 endroits sont décidés par leurs probabilités</translation>
    </message>
    <message>
        <source>Correct it with any tool   {skip_doubt} goes on   {take_back_answer} takes back   {leave} ends</source>
        <translation>Corrigez-le avec n’importe quel outil   {skip_doubt} continue   {take_back_answer} reprend la réponse   {leave} termine</translation>
    </message>
    <message>
        <source>all points of the scan lie at one place: nothing follows from them that could be asked about</source>
        <translation>tous les points du scan sont au même endroit&#xa0;: rien n’en résulte sur quoi interroger</translation>
    </message>
    <message>
        <source>The search for doubts did not end: %1.</source>
        <translation>La recherche de doutes n’a pas abouti&#xa0;: %1.</translation>
    </message>
    <message>
        <source>{ask_doubts} searches again</source>
        <translation>{ask_doubts} cherche de nouveau</translation>
    </message>
    <message>
        <source>Looking for doubts…   {leave} ends</source>
        <translation>Recherche de doutes…   {leave} termine</translation>
    </message>
    <message>
        <source>{answer_none} none   {skip_doubt} skip   {take_back_answer} back   {leave} ends</source>
        <translation>{answer_none} aucune   {skip_doubt} passer   {take_back_answer} reprendre   {leave} terminer</translation>
    </message>
    <message>
        <source>Nothing that is listed is in doubt</source>
        <translation>Rien de ce qui est listé n’est en doute</translation>
    </message>
    <message>
        <source>1 change is shown. To make it, choose Decide the Rest by Odds again; Esc drops it</source>
        <translation>1 changement est affiché. Pour le faire, choisissez encore Décider du reste&#xa0;; Échap l’abandonne</translation>
    </message>
    <message>
        <source>%1 changes are shown. To make them, choose Decide the Rest by Odds again; Esc drops them</source>
        <translation>%1 changements sont affichés. Pour les faire, choisissez encore Décider du reste&#xa0;; Échap les abandonne</translation>
    </message>
    <message>
        <source>Choose Decide the Rest by Odds again to make the changes   {leave} drops them</source>
        <translation>Choisissez encore Décider du reste pour faire les changements   {leave} les abandonne</translation>
    </message>
    <message>
        <source>Answer the Question</source>
        <translation>Répondre à la question</translation>
    </message>
    <message>
        <source>Not answered: the question was not drawn yet. Answer it now</source>
        <translation>Sans réponse&#xa0;: la question n’était pas encore affichée. Répondez maintenant</translation>
    </message>
</context>
<context>
    <name>espalier::AxisReviewModel</name>
    <message>
        <source>reviewed</source>
        <translation>révisé</translation>
    </message>
    <message>
        <source>%1 doubtful</source>
        <translation>%1 douteux</translation>
    </message>
    <message>
        <source>%1 to do</source>
        <translation>%1 à faire</translation>
    </message>
    <message>
        <source>Axis %1 of order %2, from node %3: %4</source>
        <translation>Axe %1 d’ordre %2, depuis le nœud %3&#xa0;: %4</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fait</translation>
    </message>
</context>
<context>
    <name>espalier::BlendBar</name>
    <message>
        <source>Scanned</source>
        <translation>Scanné</translation>
    </message>
    <message>
        <source>How far points have gone to where they are contracted</source>
        <translation>Avancée des points vers leur place contractée</translation>
    </message>
    <message>
        <source>Moves the points between where they were scanned and where contraction puts them</source>
        <translation>Déplace les points entre leur place scannée et celle où la contraction les met</translation>
    </message>
    <message>
        <source>Contracted</source>
        <translation>Contracté</translation>
    </message>
    <message>
        <source>Displacements</source>
        <translation>Déplacements</translation>
    </message>
    <message>
        <source>Shows a line from where a point was scanned to where it is now</source>
        <translation>Montre un trait entre la place scannée d’un point et sa place actuelle</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Shows points and contracted points as usual</source>
        <translation>Affiche comme d’habitude les points et les points contractés</translation>
    </message>
</context>
<context>
    <name>espalier::CheckForm</name>
    <message>
        <source>From where on the checks report something</source>
        <translation>À partir d’où les contrôles signalent quelque chose</translation>
    </message>
    <message>
        <source>Limits of the checks</source>
        <translation>Limites des contrôles</translation>
    </message>
    <message>
        <source>Limits of the checks (%1 set)</source>
        <translation>Limites des contrôles (%1 fixées)</translation>
    </message>
</context>
<context>
    <name>espalier::ChoicesFlow</name>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>Record the Choice</source>
        <translation>Consigner le choix</translation>
    </message>
    <message>
        <source>Keeps what is compared, or the sweep, with the project and in the report</source>
        <translation>Garde ce qui est comparé, ou le balayage, avec le projet et dans le rapport</translation>
    </message>
    <message>
        <source>Forget the Last Choice Recorded</source>
        <translation>Oublier le dernier choix consigné</translation>
    </message>
    <message>
        <source>Takes the last one out of the project and the report</source>
        <translation>Retire le dernier du projet et du rapport</translation>
    </message>
    <message>
        <source>there is nothing to record: show Preview in Numbers, or run a sweep, first</source>
        <translation>il n’y a rien à consigner&#xa0;: affichez d’abord l’aperçu en chiffres, ou lancez un balayage</translation>
    </message>
    <message>
        <source>Recorded: %1</source>
        <translation>Consigné&#xa0;: %1</translation>
    </message>
    <message>
        <source>Forgotten: %1</source>
        <translation>Oublié&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>espalier::CleanFlow</name>
    <message>
        <source>%1 of %2 points, %3 %</source>
        <translation>%1 points sur %2, %3 %</translation>
    </message>
    <message>
        <source>Pole</source>
        <translation>Poteau</translation>
    </message>
    <message>
        <source>Wire</source>
        <translation>Câble</translation>
    </message>
    <message>
        <source>Plant</source>
        <translation>Plante</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinceau</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Boîte</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Cleaning</source>
        <translation>Nettoyage</translation>
    </message>
    <message>
        <source>Clean Scan…</source>
        <translation>Nettoyer le scan…</translation>
    </message>
    <message>
        <source>Finds ground, poles, wires, other plants and stray points, and sets them aside</source>
        <translation>Trouve le sol, les poteaux, les câbles, les autres plantes et les points isolés, et les met de côté</translation>
    </message>
    <message>
        <source>Finding points</source>
        <translation>Recherche de points</translation>
    </message>
    <message>
        <source>%1: none was found there</source>
        <translation>%1&#xa0;: rien de tel n’a été trouvé ici</translation>
    </message>
    <message>
        <source>What is found is selected: mend it with the brush before you set it aside.</source>
        <translation>Ce qui est trouvé est sélectionné&#xa0;: retouchez-le au pinceau avant de le mettre de côté.</translation>
    </message>
    <message>
        <source>%1: nothing found</source>
        <translation>%1&#xa0;: rien trouvé</translation>
    </message>
    <message>
        <source>Selected: %1</source>
        <translation>Sélection&#xa0;: %1</translation>
    </message>
    <message>
        <source>No point is set aside</source>
        <translation>Aucun point n’est mis de côté</translation>
    </message>
    <message>
        <source>Set aside: %1</source>
        <translation>Mis de côté&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>espalier::CleanPanel</name>
    <message>
        <source>Find Again</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Set Aside</source>
        <translation>Mettre de côté</translation>
    </message>
    <message>
        <source>Select by hand</source>
        <translation>Sélectionner à la main</translation>
    </message>
    <message>
        <source>Find by clicks</source>
        <translation>Trouver par clics</translation>
    </message>
    <message>
        <source>Cleaning</source>
        <translation>Nettoyage</translation>
    </message>
    <message>
        <source>What to find</source>
        <translation>Que chercher</translation>
    </message>
    <message>
        <source>Choose what to find…</source>
        <translation>Choisissez que chercher…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Selects once more what the method finds among the points in use</source>
        <translation>Sélectionne une fois de plus ce que la méthode trouve parmi les points utilisés</translation>
    </message>
    <message>
        <source>The selected points take part in nothing until they are brought back</source>
        <translation>Les points sélectionnés ne comptent pour rien jusqu’à ce qu’ils soient repris</translation>
    </message>
    <message>
        <source>Keep Only</source>
        <translation>Garder seuls</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Inverser</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Afficher</translation>
    </message>
    <message>
        <source>Looking for them… %1 %</source>
        <translation>Recherche… %1 %</translation>
    </message>
</context>
<context>
    <name>espalier::ClipHandles</name>
    <message>
        <source>Back</source>
        <translation>Arrière</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Avant</translation>
    </message>
</context>
<context>
    <name>espalier::ClipPanel</name>
    <message>
        <source>Fade</source>
        <translation>Estomper</translation>
    </message>
    <message>
        <source>The farther back, the paler</source>
        <translation>Plus c’est loin, plus c’est pâle</translation>
    </message>
    <message>
        <source>Fade by depth</source>
        <translation>Estomper selon la profondeur</translation>
    </message>
    <message>
        <source>Around</source>
        <translation>Autour</translation>
    </message>
    <message>
        <source>Fade around what one flew to</source>
        <translation>Estomper autour de ce que l’on a rejoint</translation>
    </message>
    <message>
        <source>Show All Again</source>
        <translation>Tout réafficher</translation>
    </message>
    <message>
        <source>Slab facing the viewer</source>
        <translation>Tranche face à l’observateur</translation>
    </message>
    <message>
        <source>Shows what is neither nearer nor farther; turns with the view</source>
        <translation>Montre ce qui n’est ni plus près ni plus loin&#xa0;; tourne avec la vue</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Arrière</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Boîte</translation>
    </message>
    <message>
        <source>Shows what lies between these coordinates</source>
        <translation>Montre ce qui se trouve entre ces coordonnées</translation>
    </message>
    <message>
        <source>Least %1</source>
        <translation>Minimum %1</translation>
    </message>
    <message>
        <source>Greatest %1</source>
        <translation>Maximum %1</translation>
    </message>
    <message>
        <source>Box [%1]</source>
        <translation>Boîte [%1]</translation>
    </message>
    <message>
        <source>How pale the rest gets when you go to a finding, a doubt or a stop of the review: what is nearer or farther, and not of the same branch</source>
        <translation>Pâleur du reste quand vous allez à un constat, à un doute ou à un arrêt de la révision&#xa0;: ce qui est plus près ou plus loin et n’est pas de la même branche</translation>
    </message>
</context>
<context>
    <name>espalier::CloseLookFlow</name>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Look Closely</source>
        <translation>Vue rapprochée</translation>
    </message>
    <message>
        <source>Shows what is under the pointer, or selected, from where it is seen best</source>
        <translation>Montre ce qui est sous le pointeur, ou sélectionné, du côté où on le voit le mieux</translation>
    </message>
    <message>
        <source>Look Back</source>
        <translation>Vue précédente</translation>
    </message>
    <message>
        <source>Goes back to where one looked closely from</source>
        <translation>Revient là d’où l’on a regardé de près</translation>
    </message>
    <message>
        <source>put the pointer on the plant, or select nodes to look at</source>
        <translation>mettez le pointeur sur la plante, ou sélectionnez des nœuds à regarder</translation>
    </message>
    <message>
        <source>there is no view to go back to: look closely first</source>
        <translation>il n’y a pas de vue à laquelle revenir&#xa0;: regardez d’abord de près</translation>
    </message>
</context>
<context>
    <name>espalier::ColorBar</name>
    <message>
        <source>Color range of %1</source>
        <translation>Plage de couleurs de %1</translation>
    </message>
    <message>
        <source>Drag an end to set the range, click its number to type it; double click for the usual range</source>
        <translation>Glisser un bout pour fixer la plage, cliquer son nombre pour le saisir&#xa0;; double clic pour la plage habituelle</translation>
    </message>
    <message>
        <source>Least value of the color range</source>
        <translation>Plus petite valeur de la plage de couleurs</translation>
    </message>
    <message>
        <source>Greatest value of the color range</source>
        <translation>Plus grande valeur de la plage de couleurs</translation>
    </message>
    <message>
        <source>This is no number: the range stays as it was</source>
        <translation>Ce n’est pas un nombre&#xa0;: la plage reste telle quelle</translation>
    </message>
    <message>
        <source>The least value must be below %1</source>
        <translation>La plus petite valeur doit être inférieure à %1</translation>
    </message>
    <message>
        <source>The greatest value must be above %1</source>
        <translation>La plus grande valeur doit être supérieure à %1</translation>
    </message>
</context>
<context>
    <name>espalier::ColumnHeader</name>
    <message>
        <source>intensity</source>
        <translation>intensité</translation>
    </message>
    <message>
        <source>red</source>
        <translation>rouge</translation>
    </message>
    <message>
        <source>green</source>
        <translation>vert</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>bleu</translation>
    </message>
    <message>
        <source>station</source>
        <translation>station</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>écarté</translation>
    </message>
    <message>
        <source>Column %1 holds</source>
        <translation>Contenu de la colonne %1</translation>
    </message>
    <message>
        <source>What column %1 of the file holds</source>
        <translation>Ce que contient la colonne %1 du fichier</translation>
    </message>
</context>
<context>
    <name>espalier::ColumnTable</name>
    <message>
        <source>No column holds %1: choose it above one of them.</source>
        <translation>Aucune colonne ne contient %1&#xa0;: choisissez-le au-dessus de l’une d’elles.</translation>
    </message>
    <message>
        <source>Two columns hold %1: choose something else above one of them.</source>
        <translation>Deux colonnes contiennent %1&#xa0;: choisissez autre chose au-dessus de l’une d’elles.</translation>
    </message>
    <message>
        <source>A color is red, green and blue: choose all three, or none of them.</source>
        <translation>Une couleur, c’est rouge, vert et bleu&#xa0;: choisissez les trois, ou aucun.</translation>
    </message>
    <message>
        <source>The first lines of the file</source>
        <translation>Les premières lignes du fichier</translation>
    </message>
    <message>
        <source>Line %1 has %2 values, too few for these columns: choose others, or mend the file.</source>
        <translation>La ligne %1 a %2 valeurs, trop peu pour ces colonnes&#xa0;: choisissez-en d’autres, ou corrigez le fichier.</translation>
    </message>
    <message>
        <source>Line %1 has “%2” for %3, which is no number: choose other columns, or mend the file.</source>
        <translation>La ligne %1 a «&#xa0;%2&#xa0;» pour %3, ce qui n’est pas un nombre&#xa0;: choisissez d’autres colonnes, ou corrigez le fichier.</translation>
    </message>
</context>
<context>
    <name>espalier::CommandPalette</name>
    <message>
        <source>Type a command</source>
        <translation>Saisissez une commande</translation>
    </message>
    <message>
        <source>No command has this name</source>
        <translation>Aucune commande ne porte ce nom</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>espalier::CommitMarksDialog</name>
    <message>
        <source>Commit Marks to a Scale</source>
        <translation>Convertir les marques en échelle</translation>
    </message>
    <message>
        <source>Class of the units</source>
        <translation>Classe des unités</translation>
    </message>
    <message>
        <source>Made of</source>
        <translation>Faites de</translation>
    </message>
    <message>
        <source>Commit</source>
        <translation>Convertir</translation>
    </message>
    <message>
        <source>%1 (scale %2)</source>
        <translation>%1 (échelle %2)</translation>
    </message>
    <message>
        <source>such as S or GU</source>
        <translation>p.&#xa0;ex. S ou GU</translation>
    </message>
    <message>
        <source>1 unit</source>
        <translation>1 unité</translation>
    </message>
    <message>
        <source>%1 units</source>
        <translation>%1 unités</translation>
    </message>
    <message>
        <source>1 mark</source>
        <translation>1 marque</translation>
    </message>
    <message>
        <source>%1 marks</source>
        <translation>%1 marques</translation>
    </message>
    <message>
        <source>Makes %1 of scale %2 from %3: one begins at each mark, at each root, and wherever a coarser unit begins. Finer scales move down by one.</source>
        <translation>Fait %1 d’échelle %2 à partir de %3&#xa0;: une commence à chaque marque, à chaque racine et partout où commence une unité plus grossière. Les échelles plus fines descendent d’un rang.</translation>
    </message>
</context>
<context>
    <name>espalier::ConsensusFlow</name>
    <message>
        <source>Evaluate</source>
        <translation>Évaluer</translation>
    </message>
    <message>
        <source>&amp;Keep What Both Agree On</source>
        <translation>&amp;Garder ce que les deux ont</translation>
    </message>
    <message>
        <source>Consensus: leaves the wood that the plant and its reference both have; the rest is then decided place by place</source>
        <translation>Consensus&#xa0;: laisse le bois que la plante et sa référence ont toutes deux&#xa0;; le reste se décide ensuite lieu par lieu</translation>
    </message>
    <message>
        <source>there is no skeleton: make one first</source>
        <translation>il n’y a pas de squelette&#xa0;: faites-en un d’abord</translation>
    </message>
    <message>
        <source>load what another expert has of this plant as the reference first (File &gt; Load Reference)</source>
        <translation>chargez d’abord comme référence ce qu’un autre expert a de cette plante (Fichier &gt; Charger la référence)</translation>
    </message>
    <message>
        <source>what you have is kept as a version, and only a project keeps versions: save the plant as one first</source>
        <translation>ce que vous avez est gardé comme version, et seul un projet garde des versions&#xa0;: enregistrez d’abord la plante comme projet</translation>
    </message>
    <message>
        <source>Finding what both agree on</source>
        <translation>Recherche de ce que les deux ont</translation>
    </message>
    <message>
        <source>the plant was edited meanwhile: choose Keep What Both Agree On again</source>
        <translation>la plante a été modifiée entre-temps&#xa0;: choisissez de nouveau Garder ce que les deux ont</translation>
    </message>
    <message>
        <source>%1 has none of the wood of this plant where it lies: show the evaluation (F5), which lays it on the plant, or check that both are of one scan</source>
        <translation>%1 n’a rien du bois de cette plante là où il se trouve&#xa0;: affichez l’évaluation (F5), qui le pose sur la plante, ou vérifiez que les deux sont d’un même scan</translation>
    </message>
    <message>
        <source>Both agree: there is no place to decide</source>
        <translation>Les deux s’accordent&#xa0;: il n’y a rien à décider</translation>
    </message>
    <message>
        <source>Before agreement with %1</source>
        <translation>Avant l’accord avec %1</translation>
    </message>
    <message>
        <source>Keep What Both Agree On</source>
        <translation>Garder ce que les deux ont</translation>
    </message>
    <message>
        <source>What both agree on is kept: %1 % of this plant, %2 % of %3. F3 leads to the rest of %3; for yours, compare with the version “%4”</source>
        <translation>Ce que les deux ont est gardé&#xa0;: %1&#xa0;% de cette plante, %2&#xa0;% de %3. F3 mène au reste de %3&#xa0;; pour le vôtre, comparez avec la version «&#xa0;%4&#xa0;»</translation>
    </message>
    <message>
        <source>%1 is far larger or smaller than this plant: both have to be in one unit</source>
        <translation>%1 est bien plus grand ou plus petit que cette plante&#xa0;: les deux doivent être dans une même unité</translation>
    </message>
</context>
<context>
    <name>espalier::CoverageBar</name>
    <message>
        <source>Review coverage</source>
        <translation>Avancement de la révision</translation>
    </message>
    <message>
        <source>%1 % reviewed, %2 % doubtful</source>
        <translation>%1 % révisé, %2 % douteux</translation>
    </message>
</context>
<context>
    <name>espalier::CrossSectionPanel</name>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Hull</source>
        <translation>Enveloppe convexe</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Cercle</translation>
    </message>
    <message>
        <source>no direction</source>
        <translation>pas de direction</translation>
    </message>
    <message>
        <source>too few points</source>
        <translation>trop peu de points</translation>
    </message>
    <message>
        <source>points on one side only</source>
        <translation>points d’un seul côté</translation>
    </message>
    <message>
        <source>no circle in the points</source>
        <translation>pas de cercle dans les points</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Appliquer</translation>
    </message>
    <message>
        <source>Cross-section</source>
        <translation>Section</translation>
    </message>
    <message>
        <source>Measured by</source>
        <translation>Mesuré par</translation>
    </message>
    <message>
        <source>What the dashed circle is taken from</source>
        <translation>D’où vient le cercle en tirets</translation>
    </message>
    <message>
        <source>Gives the node the center and the radius of the dashed circle</source>
        <translation>Donne au nœud le centre et le rayon du cercle en tirets</translation>
    </message>
    <message>
        <source>Drag the center or the rim. Wheel: zoom. Double click: show all</source>
        <translation>Glisser le centre ou le bord. Molette&#xa0;: zoomer. Double clic&#xa0;: tout afficher</translation>
    </message>
    <message>
        <source>Radius %1. %2</source>
        <translation>Rayon %1. %2</translation>
    </message>
    <message>
        <source>Center node %1</source>
        <translation>Centrer le nœud %1</translation>
    </message>
    <message>
        <source>Set the radius of node %1</source>
        <translation>Définir le rayon du nœud %1</translation>
    </message>
    <message>
        <source>clean</source>
        <translation>net</translation>
    </message>
    <message>
        <source>rough</source>
        <translation>grossier</translation>
    </message>
    <message>
        <source>poor</source>
        <translation>mauvais</translation>
    </message>
    <message>
        <source>points all around (%1)</source>
        <translation>points tout autour (%1)</translation>
    </message>
    <message>
        <source>points on %1 of the circle</source>
        <translation>points sur %1 du cercle</translation>
    </message>
    <message>
        <source>%1, %2; error %3 (%4): %5</source>
        <translation>%1, %2&#xa0;; erreur %3 (%4)&#xa0;: %5</translation>
    </message>
    <message>
        <source>No section: the node has no neighbor that gives it a direction.</source>
        <translation>Pas de section&#xa0;: le nœud n’a pas de voisin qui lui donne une direction.</translation>
    </message>
    <message>
        <source>No %1: too few points here (%2).</source>
        <translation>Mesure impossible (%1)&#xa0;: trop peu de points ici (%2).</translation>
    </message>
    <message>
        <source>No %1: the points cover less than %2 of the circle.</source>
        <translation>Mesure impossible (%1)&#xa0;: les points couvrent moins de %2 du cercle.</translation>
    </message>
    <message>
        <source>No %1: the points lie about no circle.</source>
        <translation>Mesure impossible (%1)&#xa0;: les points n’entourent aucun cercle.</translation>
    </message>
</context>
<context>
    <name>espalier::CrossSectionView</name>
    <message>
        <source>Cross-section</source>
        <translation>Section</translation>
    </message>
</context>
<context>
    <name>espalier::DensityCurve</name>
    <message>
        <source>Radius over the density of the points</source>
        <translation>Rayon selon la densité des points</translation>
    </message>
    <message>
        <source>%1 = %2 spacings</source>
        <translation>%1 = %2 espacements</translation>
    </message>
    <message>
        <source>Curve %1</source>
        <translation>Courbe %1</translation>
    </message>
    <message>
        <source>Least %1</source>
        <translation>Minimum %1</translation>
    </message>
    <message>
        <source>Greatest %1</source>
        <translation>Maximum %1</translation>
    </message>
    <message>
        <source>Radius over the density of the points: drag a handle</source>
        <translation>Rayon selon la densité des points&#xa0;: glisser une poignée</translation>
    </message>
    <message>
        <source>Drag up or down to bend the curve</source>
        <translation>Glisser vers le haut ou le bas pour courber la courbe</translation>
    </message>
    <message>
        <source>Drag to set the radius where points lie thinnest</source>
        <translation>Glisser pour fixer le rayon là où les points sont les plus épars</translation>
    </message>
    <message>
        <source>Drag to set the radius where points lie densest</source>
        <translation>Glisser pour fixer le rayon là où les points sont les plus denses</translation>
    </message>
    <message>
        <source>Shift: finely. Double click: the default.</source>
        <translation>Maj&#xa0;: finement. Double clic&#xa0;: valeur par défaut.</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>rayon</translation>
    </message>
    <message>
        <source>spacings</source>
        <translation>espacements</translation>
    </message>
    <message>
        <source>thinnest</source>
        <translation>plus épars</translation>
    </message>
    <message>
        <source>densest</source>
        <translation>plus dense</translation>
    </message>
</context>
<context>
    <name>espalier::DifferencesPanel</name>
    <message>
        <source>The reference has %1 here that the plant lacks</source>
        <translation>La référence a ici %1 qui manquent à la plante</translation>
    </message>
    <message>
        <source>The plant has %1 here that the reference lacks</source>
        <translation>La plante a ici %1 qui manquent à la référence</translation>
    </message>
    <message>
        <source>%1 of the plant are attached to something else in the reference</source>
        <translation>%1 de la plante sont attachés à autre chose dans la référence</translation>
    </message>
    <message>
        <source>on node %1</source>
        <translation>sur le nœud %1</translation>
    </message>
    <message>
        <source>beside the plant</source>
        <translation>à côté de la plante</translation>
    </message>
    <message>
        <source>node %1</source>
        <translation>nœud %1</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Erreurs</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Endroit</translation>
    </message>
    <message>
        <source>Ignored: %1</source>
        <translation>Ignorée&#xa0;: %1</translation>
    </message>
    <message>
        <source>1 error</source>
        <translation>1 erreur</translation>
    </message>
    <message>
        <source>%1 errors</source>
        <translation>%1 erreurs</translation>
    </message>
    <message>
        <source>%1 ignored</source>
        <translation>%1 ignorées</translation>
    </message>
</context>
<context>
    <name>espalier::Divider</name>
    <message>
        <source>Divider between two states of the plant</source>
        <translation>Séparation entre deux états de la plante</translation>
    </message>
    <message>
        <source>Drag to show more of one or the other; arrow keys move it as well</source>
        <translation>Glisser pour montrer davantage de l’un ou de l’autre&#xa0;; les flèches la déplacent aussi</translation>
    </message>
</context>
<context>
    <name>espalier::DoubtsFlow</name>
    <message>
        <source>Looking for doubts</source>
        <translation>Recherche de doutes</translation>
    </message>
    <message>
        <source>Answer: %1</source>
        <translation>Réponse&#xa0;: %1</translation>
    </message>
    <message>
        <source>Answer: none of these</source>
        <translation>Réponse&#xa0;: aucune d’elles</translation>
    </message>
    <message>
        <source>no answer is left to be taken back</source>
        <translation>il ne reste aucune réponse à reprendre</translation>
    </message>
    <message>
        <source>other edits came after that answer: undo them first</source>
        <translation>d’autres modifications ont suivi cette réponse&#xa0;: annulez-les d’abord</translation>
    </message>
    <message>
        <source>Decide by odds</source>
        <translation>Décider par les probabilités</translation>
    </message>
    <message>
        <source>it was stopped</source>
        <translation>elle a été arrêtée</translation>
    </message>
</context>
<context>
    <name>espalier::EdgeDelegate</name>
    <message>
        <source>Type of the edge</source>
        <translation>Type de l’arête</translation>
    </message>
    <message>
        <source>&lt; continues the axis</source>
        <translation>&lt; poursuit l’axe</translation>
    </message>
    <message>
        <source>+ begins an axis</source>
        <translation>+ commence un axe</translation>
    </message>
</context>
<context>
    <name>espalier::EditChoices</name>
    <message>
        <source>Merge Paths</source>
        <translation>Fusionner les chemins</translation>
    </message>
    <message>
        <source>The edit distance lets one part stand for up to three that follow each other, as where a spur cuts a segment in two</source>
        <translation>La distance d’édition laisse une partie en représenter jusqu’à trois qui se suivent, comme là où un rameau court coupe un segment en deux</translation>
    </message>
    <message>
        <source>Edits of Nodes</source>
        <translation>Édition des nœuds</translation>
    </message>
    <message>
        <source>The edit distance edits single nodes</source>
        <translation>La distance d’édition modifie des nœuds un à un</translation>
    </message>
    <message>
        <source>Edits of Segments</source>
        <translation>Édition des segments</translation>
    </message>
    <message>
        <source>The edit distance edits unbranched segments</source>
        <translation>La distance d’édition modifie des segments sans ramification</translation>
    </message>
    <message>
        <source>Edits of Axes</source>
        <translation>Édition des axes</translation>
    </message>
    <message>
        <source>The edit distance edits whole axes</source>
        <translation>La distance d’édition modifie des axes entiers</translation>
    </message>
    <message>
        <source>Cost of Edits: Topology</source>
        <translation>Coût d’édition&#xa0;: topologie</translation>
    </message>
    <message>
        <source>A part costs 1 to remove or insert, and nothing to take for another</source>
        <translation>Une partie coûte 1 à supprimer ou à insérer, et rien à prendre pour une autre</translation>
    </message>
    <message>
        <source>Cost of Edits: Attributes</source>
        <translation>Coût d’édition&#xa0;: attributs</translation>
    </message>
    <message>
        <source>As by topology, and taking one part for another costs up to 2, by length, radius, order and direction</source>
        <translation>Comme pour la topologie, et prendre une partie pour une autre coûte jusqu’à 2, selon la longueur, le rayon, l’ordre et la direction</translation>
    </message>
    <message>
        <source>Cost of Edits: Length</source>
        <translation>Coût d’édition&#xa0;: longueur</translation>
    </message>
    <message>
        <source>A part costs its length, or the difference to that of another</source>
        <translation>Une partie coûte sa longueur, ou la différence avec celle d’une autre</translation>
    </message>
    <message>
        <source>Cost of Edits: Place</source>
        <translation>Coût d’édition&#xa0;: place</translation>
    </message>
    <message>
        <source>As by length, and the distance between the centers of two parts</source>
        <translation>Comme pour la longueur, et la distance entre les centres de deux parties</translation>
    </message>
    <message>
        <source>Cost of Edits: Shape</source>
        <translation>Coût d’édition&#xa0;: forme</translation>
    </message>
    <message>
        <source>A part costs its length, or the Hausdorff distance to another</source>
        <translation>Une partie coûte sa longueur, ou la distance de Hausdorff à une autre</translation>
    </message>
</context>
<context>
    <name>espalier::EditFlow</name>
    <message>
        <source>Edit</source>
        <translation>Édition</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>&amp;Tout sélectionner</translation>
    </message>
    <message>
        <source>Selects all nodes but the hidden ones</source>
        <translation>Sélectionne tous les nœuds, sauf ceux qui sont masqués</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Quitter</translation>
    </message>
    <message>
        <source>Leaves the gesture, the tool, or the selection</source>
        <translation>Quitte le geste, l’outil ou la sélection</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>Takes the last edit back</source>
        <translation>Annule la dernière modification</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>Makes the edit again</source>
        <translation>Refait la modification</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Annuler&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Rétablir&#xa0;: %1</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>Annulé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Redone: %1</source>
        <translation>Rétabli&#xa0;: %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Drop the &amp;Preview</source>
        <translation>Abandonner l’a&amp;perçu</translation>
    </message>
</context>
<context>
    <name>espalier::Editing</name>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Accepter</translation>
    </message>
    <message>
        <source>Makes what the preview shows</source>
        <translation>Applique ce que montre l’aperçu</translation>
    </message>
    <message>
        <source>Skeleton</source>
        <translation>Squelette</translation>
    </message>
    <message>
        <source>%1: nothing to change here</source>
        <translation>%1&#xa0;: rien à changer ici</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Sélection</translation>
    </message>
    <message>
        <source>Select &amp;Through</source>
        <translation>Sélectionner à tra&amp;vers</translation>
    </message>
    <message>
        <source>Clicks, boxes and lassos also take what is hidden behind wood</source>
        <translation>Clics, boîtes et lassos prennent aussi ce qui est caché derrière du bois</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Turn Around This</source>
        <translation>Tourner autour d’ici</translation>
    </message>
    <message>
        <source>The place under the pointer stays in the middle</source>
        <translation>L’endroit sous le pointeur reste au milieu</translation>
    </message>
    <message>
        <source>Frame Selection</source>
        <translation>Cadrer la sélection</translation>
    </message>
    <message>
        <source>The chosen nodes fill the view</source>
        <translation>Les nœuds choisis remplissent la vue</translation>
    </message>
    <message>
        <source>Drag: turn   Right drag: pan   Wheel: zoom</source>
        <translation>Glisser&#xa0;: tourner   Bouton droit&#xa0;: déplacer   Molette&#xa0;: zoomer</translation>
    </message>
    <message>
        <source>Read-only   %1</source>
        <translation>Lecture seule   %1</translation>
    </message>
    <message>
        <source>Edge of %1</source>
        <translation>Arête&#xa0;: %1</translation>
    </message>
    <message>
        <source>Empty space</source>
        <translation>Espace vide</translation>
    </message>
    <message>
        <source>Point at %1</source>
        <translation>Point à %1</translation>
    </message>
    <message>
        <source>put the pointer on a node, or select one</source>
        <translation>mettez le pointeur sur un nœud, ou sélectionnez-en un</translation>
    </message>
    <message>
        <source>select the node to go on from, or add a child first</source>
        <translation>sélectionnez le nœud à partir duquel continuer, ou ajoutez d’abord un enfant</translation>
    </message>
    <message>
        <source>{accept} takes %1</source>
        <translation>{accept} prend %1</translation>
    </message>
</context>
<context>
    <name>espalier::EnvelopeFlow</name>
    <message>
        <source>Export Envelope…</source>
        <translation>Exporter l’enveloppe…</translation>
    </message>
    <message>
        <source>Writes the surface about the crown as a mesh, PLY or OBJ</source>
        <translation>Écrit la surface autour du houppier sous forme de maillage, PLY ou OBJ</translation>
    </message>
    <message>
        <source>Crown Envelope</source>
        <translation>Enveloppe du houppier</translation>
    </message>
    <message>
        <source>Crown Envelope…</source>
        <translation>Enveloppe du houppier…</translation>
    </message>
    <message>
        <source>Draws a closed surface about the crown, and measures its volume and area</source>
        <translation>Dessine une surface fermée autour du houppier, et mesure son volume et son aire</translation>
    </message>
    <message>
        <source>Crown envelope: fit again</source>
        <translation>Enveloppe du houppier&#xa0;: ajuster à nouveau</translation>
    </message>
    <message>
        <source>Crown envelope: none</source>
        <translation>Enveloppe du houppier&#xa0;: aucune</translation>
    </message>
    <message>
        <source>Crown envelope: %1</source>
        <translation>Enveloppe du houppier&#xa0;: %1</translation>
    </message>
    <message>
        <source>Crown envelope: about the skeleton</source>
        <translation>Enveloppe du houppier&#xa0;: autour du squelette</translation>
    </message>
    <message>
        <source>Crown envelope: about the points</source>
        <translation>Enveloppe du houppier&#xa0;: autour des points</translation>
    </message>
    <message>
        <source>Crown envelope: %1, %2</source>
        <translation>Enveloppe du houppier&#xa0;: %1, %2</translation>
    </message>
    <message>
        <source>There is no plant to draw it about.</source>
        <translation>Il n’y a pas de plante autour de laquelle la dessiner.</translation>
    </message>
    <message>
        <source>There is no skeleton to draw it about.</source>
        <translation>Il n’y a pas de squelette autour duquel la dessiner.</translation>
    </message>
    <message>
        <source>Crown envelope</source>
        <translation>Enveloppe du houppier</translation>
    </message>
    <message>
        <source>It follows from the plant alone: it has no handles to drag.</source>
        <translation>Elle suit de la plante seule&#xa0;: elle n’a pas de poignées à glisser.</translation>
    </message>
    <message>
        <source>By hand: handles were dragged.</source>
        <translation>À la main&#xa0;: des poignées ont été déplacées.</translation>
    </message>
    <message>
        <source>Drag its handles to set it by hand.</source>
        <translation>Glissez ses poignées pour la régler à la main.</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Aire</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Crown diameter</source>
        <translation>Diamètre du houppier</translation>
    </message>
    <message>
        <source>Of a circle as large as its convex outline from above</source>
        <translation>D’un cercle aussi grand que son contour convexe vu d’en haut</translation>
    </message>
    <message>
        <source>Crown envelope: drag %1</source>
        <translation>Enveloppe du houppier&#xa0;: glisser %1</translation>
    </message>
    <message>
        <source>The envelope holds %1 now</source>
        <translation>L’enveloppe contient maintenant %1</translation>
    </message>
    <message>
        <source>Export the envelope</source>
        <translation>Exporter l’enveloppe</translation>
    </message>
    <message>
        <source>PLY surface (*.ply);;OBJ surface (*.obj)</source>
        <translation>Surface PLY (*.ply);;Surface OBJ (*.obj)</translation>
    </message>
    <message>
        <source>there is no envelope: choose a shape first</source>
        <translation>il n’y a pas d’enveloppe&#xa0;: choisissez d’abord une forme</translation>
    </message>
    <message>
        <source>%1: envelopes are written as PLY or OBJ: choose a name that ends in .ply or .obj</source>
        <translation>%1&#xa0;: les enveloppes sont écrites en PLY ou OBJ&#xa0;: choisissez un nom qui finit par .ply ou .obj</translation>
    </message>
    <message>
        <source>Wrote %1: %2 triangles</source>
        <translation>%1 écrit&#xa0;: %2 triangles</translation>
    </message>
    <message>
        <source>the crown envelope of this project cannot be read: choose it again</source>
        <translation>l’enveloppe du houppier de ce projet ne peut pas être lue&#xa0;: choisissez-la à nouveau</translation>
    </message>
    <message>
        <source>Drawing it… %1 %</source>
        <translation>Dessin en cours… %1 %</translation>
    </message>
    <message>
        <source>Drag: move %1   Esc: put it back while you drag</source>
        <translation>Glisser&#xa0;: déplacer %1   Échap&#xa0;: remettre en place pendant le glissement</translation>
    </message>
    <message>
        <source>Choose a shape: it is drawn about the plant, and measured. From height leaves out a bare stem.</source>
        <translation>Choisissez une forme&#xa0;: elle est tracée autour de la plante et mesurée. «&#xa0;À partir de la hauteur&#xa0;» laisse de côté une tige nue.</translation>
    </message>
    <message>
        <source>Evaluate</source>
        <translation>Évaluer</translation>
    </message>
</context>
<context>
    <name>espalier::EnvelopePanel</name>
    <message>
        <source>Shape of the envelope</source>
        <translation>Forme de l’enveloppe</translation>
    </message>
    <message>
        <source>What the envelope is about</source>
        <translation>Ce que l’enveloppe entoure</translation>
    </message>
    <message>
        <source>Fit Again</source>
        <translation>Ajuster à nouveau</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>About the points</source>
        <translation>Autour des points</translation>
    </message>
    <message>
        <source>About the skeleton</source>
        <translation>Autour du squelette</translation>
    </message>
    <message>
        <source>Forgets what was dragged: all follows from the plant</source>
        <translation>Oublie ce qui a été glissé&#xa0;: tout suit de la plante</translation>
    </message>
    <message>
        <source>Crown envelope</source>
        <translation>Enveloppe du houppier</translation>
    </message>
    <message>
        <source>Choose a shape: it is drawn about the plant, and measured. From height leaves out a bare stem.</source>
        <translation>Choisissez une forme&#xa0;: elle est tracée autour de la plante et mesurée. «&#xa0;À partir de la hauteur&#xa0;» laisse de côté une tige nue.</translation>
    </message>
</context>
<context>
    <name>espalier::ErrorWalk</name>
    <message>
        <source>Accept Reference</source>
        <translation>Accepter la référence</translation>
    </message>
    <message>
        <source>Add to Plant</source>
        <translation>Ajouter à la plante</translation>
    </message>
    <message>
        <source>Remove from Plant</source>
        <translation>Supprimer de la plante</translation>
    </message>
    <message>
        <source>Attach as Reference</source>
        <translation>Attacher comme la référence</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Accepter</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Attach</source>
        <translation>Attacher</translation>
    </message>
    <message>
        <source>Add %1 of the reference</source>
        <translation>Ajouter %1 de la référence</translation>
    </message>
    <message>
        <source>Remove %1 that the reference lacks</source>
        <translation>Supprimer %1 absents de la référence</translation>
    </message>
    <message>
        <source>Attach node %1 as the reference</source>
        <translation>Attacher le nœud %1 comme la référence</translation>
    </message>
    <message>
        <source>Next Error</source>
        <translation>Erreur suivante</translation>
    </message>
    <message>
        <source>Goes on to where the plant differs from its reference</source>
        <translation>Va plus loin, là où la plante diffère de sa référence</translation>
    </message>
    <message>
        <source>Previous Error</source>
        <translation>Erreur précédente</translation>
    </message>
    <message>
        <source>Goes back to where the plant differs from its reference</source>
        <translation>Revient là où la plante diffère de sa référence</translation>
    </message>
    <message>
        <source>Makes the plant there what the reference is, as one step</source>
        <translation>Rend la plante à cet endroit conforme à la référence, en une étape</translation>
    </message>
    <message>
        <source>Ignore Error</source>
        <translation>Ignorer l’erreur</translation>
    </message>
    <message>
        <source>Leaves the error out of the list, or takes it back</source>
        <translation>Laisse l’erreur hors de la liste, ou l’y remet</translation>
    </message>
    <message>
        <source>attached here</source>
        <translation>attaché ici</translation>
    </message>
    <message>
        <source>belongs here</source>
        <translation>sa place est ici</translation>
    </message>
    <message>
        <source>Nothing has been compared yet</source>
        <translation>Rien n’a encore été comparé</translation>
    </message>
    <message>
        <source>Nothing differs from the reference within the tolerance</source>
        <translation>Rien ne diffère de la référence à cette tolérance</translation>
    </message>
    <message>
        <source>nothing has been compared yet: load a reference first</source>
        <translation>rien n’a encore été comparé&#xa0;: chargez d’abord une référence</translation>
    </message>
    <message>
        <source>no error is chosen: click one, or go to the next</source>
        <translation>aucune erreur n’est choisie&#xa0;: cliquez-en une, ou allez à la suivante</translation>
    </message>
    <message>
        <source>Show Error Again</source>
        <translation>Réafficher l’erreur</translation>
    </message>
    <message>
        <source>Show Again</source>
        <translation>Réafficher</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>Ignorer</translation>
    </message>
    <message>
        <source>adds it</source>
        <translation>l’ajoute</translation>
    </message>
    <message>
        <source>removes it</source>
        <translation>l’enlève</translation>
    </message>
    <message>
        <source>lists it again</source>
        <translation>l’affiche à nouveau</translation>
    </message>
    <message>
        <source>ignores it</source>
        <translation>l’ignore</translation>
    </message>
    <message>
        <source>attaches it as the reference does</source>
        <translation>l’attache comme la référence</translation>
    </message>
    <message>
        <source>Add %1 of “%2”</source>
        <translation>Ajouter %1 de «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>Remove %1 that “%2” lacks</source>
        <translation>Supprimer %1 que «&#xa0;%2&#xa0;» n’a pas</translation>
    </message>
    <message>
        <source>Attach node %1 as in “%2”</source>
        <translation>Attacher le nœud %1 comme dans «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>%1, %2: </source>
        <translation>%1, %2&#xa0;: </translation>
    </message>
    <message>
        <source>nothing differs from the reference within the tolerance</source>
        <translation>rien ne diffère de la référence à la tolérance près</translation>
    </message>
    <message>
        <source>Listed again: %1</source>
        <translation>De nouveau dans la liste&#xa0;: %1</translation>
    </message>
    <message>
        <source>Ignored: %1. The button above the list shows what is ignored</source>
        <translation>Ignoré&#xa0;: %1. Le bouton au-dessus de la liste montre ce qui est ignoré</translation>
    </message>
    <message>
        <source>Show an error again</source>
        <translation>Réafficher une erreur</translation>
    </message>
    <message>
        <source>Ignore an error</source>
        <translation>Ignorer une erreur</translation>
    </message>
</context>
<context>
    <name>espalier::EvaluationFlow</name>
    <message>
        <source>Evaluate</source>
        <translation>Évaluer</translation>
    </message>
    <message>
        <source>Save Edit Mapping…</source>
        <translation>Enregistrer la correspondance…</translation>
    </message>
    <message>
        <source>Writes which part stands for which, and what is removed and inserted, as CSV</source>
        <translation>Écrit quelle partie en représente quelle autre, et ce qui est supprimé et inséré, en CSV</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>Évaluation</translation>
    </message>
    <message>
        <source>Shows or hides the traits and scores of the plant</source>
        <translation>Affiche ou masque les traits et les scores de la plante</translation>
    </message>
    <message>
        <source>E&amp;dit Distance</source>
        <translation>&amp;Distance d’édition</translation>
    </message>
    <message>
        <source>Canceled</source>
        <translation>Annulé</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>there is no reference to compare with: load one first</source>
        <translation>il n’y a pas de référence à comparer&#xa0;: chargez-en d’abord une</translation>
    </message>
    <message>
        <source>the plant is not compared yet, as it is: show the evaluation panel, and wait until its numbers are no longer pale</source>
        <translation>la plante n’est pas encore comparée telle qu’elle est&#xa0;: affichez le panneau d’évaluation, et attendez que ses nombres ne soient plus pâles</translation>
    </message>
    <message>
        <source>the plants have too many axes for an edit distance</source>
        <translation>les plantes ont trop d’axes pour une distance d’édition</translation>
    </message>
    <message>
        <source>the plants have too many parts for an edit distance: choose Evaluate &gt; Edit Distance &gt; Edits of Axes</source>
        <translation>les plantes ont trop de parties pour une distance d’édition&#xa0;: choisissez Évaluer &gt; Distance d’édition &gt; Édition des axes</translation>
    </message>
    <message>
        <source>Save the edit mapping</source>
        <translation>Enregistrer la correspondance</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tableaux (*.csv)</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 écrit</translation>
    </message>
</context>
<context>
    <name>espalier::EvaluationPanel</name>
    <message>
        <source>Lay on the plant</source>
        <translation>Recaler sur la plante</translation>
    </message>
    <message>
        <source>Moves the reference to where it fits the plant best; off: both are compared where their files say</source>
        <translation>Déplace la référence là où elle s’ajuste le mieux à la plante&#xa0;; décoché&#xa0;: les deux sont comparées là où le disent leurs fichiers</translation>
    </message>
    <message>
        <source>Turn it, too</source>
        <translation>Avec rotation</translation>
    </message>
    <message>
        <source>Looks for a turn by any angle about the upright axis, and by some degrees about any other, and takes it where it fits clearly better</source>
        <translation>Cherche une rotation d’un angle quelconque autour de l’axe vertical, et de quelques degrés autour de tout autre, et la prend là où l’ajustement est nettement meilleur</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>Color</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Edits</source>
        <translation>Édition</translation>
    </message>
    <message>
        <source>What the edit distance counts, and which part stands for which</source>
        <translation>Ce que compte la distance d’édition, et quelle partie en représente quelle autre</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Rapport…</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>What lies this near to the other skeleton is called matched</source>
        <translation>Ce qui est aussi près de l’autre squelette est dit apparié</translation>
    </message>
    <message>
        <source>Compared with %1</source>
        <translation>Comparé avec %1</translation>
    </message>
    <message>
        <source>moved by %1</source>
        <translation>déplacée de %1</translation>
    </message>
    <message>
        <source>The plant would be moved by (%1, %2, %3) to lie on the reference; here, the reference is moved to the plant instead. Far apart, the two files have different frames.</source>
        <translation>La plante serait déplacée de (%1, %2, %3) pour se poser sur la référence&#xa0;; ici, c’est la référence qui est déplacée vers la plante. Si elles sont éloignées, les deux fichiers ont des repères différents.</translation>
    </message>
    <message>
        <source>The plant would be turned by %1 about (%2, %3, %4) through its middle first. </source>
        <translation>La plante serait d’abord tournée de %1 autour de (%2, %3, %4) par son milieu. </translation>
    </message>
    <message>
        <source>Comparing…</source>
        <translation>Comparaison…</translation>
    </message>
    <message>
        <source>the two files lie %1 apart and are turned by %2: the reference is shown on the plant</source>
        <translation>les deux fichiers sont à %1 l’un de l’autre et tournés de %2&#xa0;: la référence est montrée sur la plante</translation>
    </message>
    <message>
        <source>the two files lie %1 apart: the reference is shown on the plant</source>
        <translation>les deux fichiers sont à %1 l’un de l’autre&#xa0;: la référence est montrée sur la plante</translation>
    </message>
</context>
<context>
    <name>espalier::EvaluationScores</name>
    <message>
        <source>Scores</source>
        <translation>Scores</translation>
    </message>
    <message>
        <source>Work by hand</source>
        <translation>Travail à la main</translation>
    </message>
    <message>
        <source>No diameters at 1.3 m: %1</source>
        <translation>Pas de diamètres à 1.3 m&#xa0;: %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>1 edit</source>
        <translation>1 modification</translation>
    </message>
    <message>
        <source>%1 edits</source>
        <translation>%1 modifications</translation>
    </message>
    <message>
        <source>Since the plant was reconstructed or opened: %1</source>
        <translation>Depuis que la plante a été reconstruite ou ouverte&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>espalier::ExpectedErrorsFlow</name>
    <message>
        <source>Where errors are likely</source>
        <translation>Où des erreurs sont probables</translation>
    </message>
</context>
<context>
    <name>espalier::ExplainedBar</name>
    <message>
        <source>Explained within</source>
        <translation>Expliqué à moins de</translation>
    </message>
    <message>
        <source>Points this near to the surface of the wood are explained by it. Sets the sensitivity of all checks</source>
        <translation>Les points aussi proches de la surface du bois sont expliqués par lui. Règle la sensibilité de tous les contrôles</translation>
    </message>
    <message>
        <source>Distance to the skeleton</source>
        <translation>Distance au squelette</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Masquer</translation>
    </message>
    <message>
        <source>Hides explained points instead of dimming them</source>
        <translation>Masque les points expliqués au lieu de les atténuer</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Shows all points as usual</source>
        <translation>Affiche tous les points comme d’habitude</translation>
    </message>
</context>
<context>
    <name>espalier::ExplainedFlow</name>
    <message>
        <source>Hide Explained Points</source>
        <translation>Masquer les points expliqués</translation>
    </message>
    <message>
        <source>Dims or hides the points near the skeleton: what is missing stands out</source>
        <translation>Atténue ou masque les points proches du squelette&#xa0;: ce qui manque ressort</translation>
    </message>
    <message>
        <source>no scan</source>
        <translation>pas de scan</translation>
    </message>
    <message>
        <source>no skeleton</source>
        <translation>pas de squelette</translation>
    </message>
    <message>
        <source>measuring…</source>
        <translation>mesure en cours…</translation>
    </message>
    <message>
        <source>%1 left, %2 %</source>
        <translation>%1 restants, %2 %</translation>
    </message>
</context>
<context>
    <name>espalier::FileFlow</name>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>Opens a scan, or a skeleton over it</source>
        <translation>Ouvre un scan, ou un squelette par-dessus</translation>
    </message>
    <message>
        <source>Open &amp;With Choices…</source>
        <translation>Ouvrir avec des c&amp;hoix…</translation>
    </message>
    <message>
        <source>Shows what is in a scan before it is read, and lets you choose columns, unit, up axis and how much of it to read</source>
        <translation>Montre ce que contient un scan avant de le lire, et laisse choisir les colonnes, l’unité, l’axe vertical et la part à lire</translation>
    </message>
    <message>
        <source>Read the Re&amp;gion in Full</source>
        <translation>Lire la ré&amp;gion en entier</translation>
    </message>
    <message>
        <source>Of a scan that is shown in part, reads all points that lie in the box the view is clipped to, as a plant of its own</source>
        <translation>D’un scan affiché en partie, lit tous les points de la boîte à laquelle la vue est découpée, comme une plante à part</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Saves the skeleton</source>
        <translation>Enregistre le squelette</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Enregistrer &amp;sous…</translation>
    </message>
    <message>
        <source>Saves the skeleton under another name</source>
        <translation>Enregistre le squelette sous un autre nom</translation>
    </message>
    <message>
        <source>&amp;Close Plant</source>
        <translation>&amp;Fermer la plante</translation>
    </message>
    <message>
        <source>Puts scan and skeleton away</source>
        <translation>Range le scan et le squelette</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>Leaves the program</source>
        <translation>Quitte le programme</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nouveau</translation>
    </message>
    <message>
        <source>Puts this plant away and begins another</source>
        <translation>Range cette plante et en commence une autre</translation>
    </message>
    <message>
        <source>Save &amp;Project As…</source>
        <translation>Enregistrer le &amp;projet sous…</translation>
    </message>
    <message>
        <source>Keeps plant, scan and history in one file, which saves itself</source>
        <translation>Garde la plante, le scan et l’historique dans un fichier, qui s’enregistre tout seul</translation>
    </message>
    <message>
        <source>Keep the Scan in the Project</source>
        <translation>Garder le scan dans le projet</translation>
    </message>
    <message>
        <source>Writes the scan into the project file, which then needs no other</source>
        <translation>Écrit le scan dans le fichier du projet, qui n’a alors besoin d’aucun autre</translation>
    </message>
    <message>
        <source>Compact Project</source>
        <translation>Compacter le projet</translation>
    </message>
    <message>
        <source>Gives back the room that the project file no longer uses</source>
        <translation>Rend la place que le fichier du projet n’utilise plus</translation>
    </message>
    <message>
        <source>&amp;Export Structure…</source>
        <translation>E&amp;xporter la structure…</translation>
    </message>
    <message>
        <source>Writes a copy of the skeleton, as MTG or another format</source>
        <translation>Écrit une copie du squelette, en MTG ou dans un autre format</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Rien pour l’instant</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Effacer la liste</translation>
    </message>
    <message>
        <source>Projects (*.espalier)</source>
        <translation>Projets (*.espalier)</translation>
    </message>
    <message>
        <source>Projects, scans and skeletons (%1)</source>
        <translation>Projets, scans et squelettes (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Scans (%1)</source>
        <translation>Scans (%1)</translation>
    </message>
    <message>
        <source>Skeletons (%1)</source>
        <translation>Squelettes (%1)</translation>
    </message>
    <message>
        <source>Skeletons and projects (%1)</source>
        <translation>Squelettes et projets (%1)</translation>
    </message>
    <message>
        <source>MTG of plant, axes and nodes (*.mtg)</source>
        <translation>MTG de plante, axes et nœuds (*.mtg)</translation>
    </message>
    <message>
        <source>MTG of plant and nodes, as PlantScan3D writes (*.mtg)</source>
        <translation>MTG de plante et nœuds, comme l’écrit PlantScan3D (*.mtg)</translation>
    </message>
    <message>
        <source>plant</source>
        <translation>plante</translation>
    </message>
    <message>
        <source>part of %1</source>
        <translation>partie de %1</translation>
    </message>
    <message>
        <source>all points of the scan are open</source>
        <translation>tous les points du scan sont ouverts</translation>
    </message>
    <message>
        <source>no region is chosen: clip the view to a box around it first, by Clipping in the View menu</source>
        <translation>aucune région n’est choisie&#xa0;: découpez d’abord la vue à une boîte autour d’elle, par Découpage dans le menu Vue</translation>
    </message>
    <message>
        <source>Open a scan or a skeleton</source>
        <translation>Ouvrir un scan ou un squelette</translation>
    </message>
    <message>
        <source>%1: open a project alone</source>
        <translation>%1&#xa0;: ouvrez un projet seul</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lecture&#xa0;: %1</translation>
    </message>
    <message>
        <source>Save the skeleton</source>
        <translation>Enregistrer le squelette</translation>
    </message>
    <message>
        <source>Export the structure</source>
        <translation>Exporter la structure</translation>
    </message>
    <message>
        <source>Unsaved edits</source>
        <translation>Modifications non enregistrées</translation>
    </message>
    <message>
        <source>&lt;b&gt;Save the edits to this skeleton?&lt;/b&gt;</source>
        <translation>&lt;b&gt;Enregistrer les modifications de ce squelette&#xa0;?&lt;/b&gt;</translation>
    </message>
    <message>
        <source>They are lost otherwise</source>
        <translation>Sinon, elles sont perdues</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Save Project As…</source>
        <translation>Enregistrer le projet sous…</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Keep editing</source>
        <translation>Continuer l’édition</translation>
    </message>
    <message>
        <source>the skeleton</source>
        <translation>le squelette</translation>
    </message>
    <message>
        <source>Move structure onto the scan</source>
        <translation>Déplacer la structure sur le scan</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Déplacer</translation>
    </message>
    <message>
        <source>Read the Region in Full</source>
        <translation>Lire la région en entier</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 enregistré</translation>
    </message>
    <message>
        <source>Another scan</source>
        <translation>Un autre scan</translation>
    </message>
    <message>
        <source>&lt;b&gt;Open %1 in place of %2?&lt;/b&gt;</source>
        <translation>&lt;b&gt;Ouvrir %1 à la place de %2&#xa0;?&lt;/b&gt;</translation>
    </message>
    <message>
        <source>If both are scans of the same plant, register %1: it is laid on %2, and the two can be joined.</source>
        <translation>Si les deux sont des scans de la même plante, recalez %1&#xa0;: il est posé sur %2, et les deux peuvent être joints.</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>Recaler</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Two scans</source>
        <translation>Deux scans</translation>
    </message>
    <message>
        <source>&lt;b&gt;Is %1 another scan of the same plant?&lt;/b&gt;</source>
        <translation>&lt;b&gt;%1 est-il un autre scan de la même plante&#xa0;?&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Then register it: it is laid on %1, and the two can be joined. Or open %1 alone, as a plant of its own.</source>
        <translation>Alors recalez-le&#xa0;: il est posé sur %1, et les deux peuvent être joints. Ou ouvrez %1 seul, comme une plante à part.</translation>
    </message>
    <message>
        <source>Open Alone</source>
        <translation>Ouvrir seul</translation>
    </message>
    <message>
        <source>The columns are read as you named them before, of a file that begins alike</source>
        <translation>Les colonnes sont lues comme vous les avez nommées auparavant, pour un fichier qui commence de même</translation>
    </message>
    <message>
        <source>Canceled: nothing has changed</source>
        <translation>Annulé&#xa0;: rien n’a changé</translation>
    </message>
    <message>
        <source>Exported %1</source>
        <translation>%1 exporté</translation>
    </message>
</context>
<context>
    <name>espalier::FindingsFlow</name>
    <message>
        <source>Check the plant</source>
        <translation>Contrôler la plante</translation>
    </message>
</context>
<context>
    <name>espalier::FolderDialog</name>
    <message>
        <source>Folder, also a new one:</source>
        <translation>Dossier, nouveau ou non&#xa0;:</translation>
    </message>
</context>
<context>
    <name>espalier::HelpFlow</name>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Find a Command…</source>
        <translation>Trouver une commande…</translation>
    </message>
    <message>
        <source>Runs any command by its name</source>
        <translation>Lance n’importe quelle commande par son nom</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Manuel</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Raccourcis</translation>
    </message>
    <message>
        <source>Shows all keys on one sheet</source>
        <translation>Montre toutes les touches sur une feuille</translation>
    </message>
    <message>
        <source>About Espalier</source>
        <translation>À propos d’Espalier</translation>
    </message>
    <message>
        <source>Its version and license, and those of all libraries</source>
        <translation>Sa version et sa licence, et celles de toutes les bibliothèques</translation>
    </message>
    <message>
        <source>Opens at the chapter of the panel, tool or dialog that you are in</source>
        <translation>S’ouvre au chapitre du panneau, de l’outil ou du dialogue où vous êtes</translation>
    </message>
</context>
<context>
    <name>espalier::HistogramView</name>
    <message>
        <source>Histogram</source>
        <translation>Histogramme</translation>
    </message>
    <message>
        <source>Histogram: %1</source>
        <translation>Histogramme&#xa0;: %1</translation>
    </message>
    <message>
        <source>Dashed line: %1</source>
        <translation>Ligne en tirets&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 have no value</source>
        <translation>%1 n’ont pas de valeur</translation>
    </message>
    <message>
        <source>Drag to mark a range, click to clear it</source>
        <translation>Glisser pour marquer une plage, cliquer pour l’effacer</translation>
    </message>
    <message>
        <source>%1 values from %2 to %3 %4</source>
        <translation>%1 valeurs de %2 à %3 %4</translation>
    </message>
</context>
<context>
    <name>espalier::HistoryFlow</name>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>Shows or hides the list of all steps</source>
        <translation>Affiche ou masque la liste de toutes les étapes</translation>
    </message>
    <message numerus="yes">
        <source>Undone: %n steps</source>
        <translation>
            <numerusform>Annulé&#xa0;: %n étape</numerusform>
            <numerusform>Annulé&#xa0;: %n étapes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Redone: %n steps</source>
        <translation>
            <numerusform>Rétabli&#xa0;: %n étape</numerusform>
            <numerusform>Rétabli&#xa0;: %n étapes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>espalier::HistoryModel</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Étape</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Heure</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Auteur</translation>
    </message>
    <message>
        <source>Opened here</source>
        <translation>Ouvert ici</translation>
    </message>
    <message>
        <source>The beginning</source>
        <translation>Le début</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>%1 ouvert</translation>
    </message>
</context>
<context>
    <name>espalier::HistoryPanel</name>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
</context>
<context>
    <name>espalier::HullFlow</name>
    <message>
        <source>Hulls</source>
        <translation>Enveloppes</translation>
    </message>
    <message>
        <source>Convex Hull of Branch</source>
        <translation>Enveloppe convexe de la branche</translation>
    </message>
    <message>
        <source>Wraps the points of all that the node carries, and keeps the volume as its feature hull_volume</source>
        <translation>Enveloppe les points de tout ce que porte le nœud, et garde le volume comme son attribut hull_volume</translation>
    </message>
    <message>
        <source>Remove Convex Hull</source>
        <translation>Supprimer l’enveloppe convexe</translation>
    </message>
    <message>
        <source>Takes the hull and its volume off the node</source>
        <translation>Ôte au nœud l’enveloppe et son volume</translation>
    </message>
    <message>
        <source>put the pointer on a branch, or select its first node</source>
        <translation>mettez le pointeur sur une branche, ou sélectionnez son premier nœud</translation>
    </message>
    <message>
        <source>there are no points to wrap: open the scan first</source>
        <translation>il n’y a pas de points à envelopper&#xa0;: ouvrez d’abord le scan</translation>
    </message>
    <message>
        <source>this node has no convex hull: choose the one that the branch begins at</source>
        <translation>ce nœud n’a pas d’enveloppe convexe&#xa0;: choisissez celui où commence la branche</translation>
    </message>
    <message>
        <source>Remove convex hull</source>
        <translation>Supprimer l’enveloppe convexe</translation>
    </message>
    <message>
        <source>Convex hulls</source>
        <translation>Enveloppes convexes</translation>
    </message>
    <message>
        <source>No hull: the points of this branch lie in a plane, or there are fewer than 4</source>
        <translation>Pas d’enveloppe&#xa0;: les points de cette branche sont dans un plan, ou il y en a moins de 4</translation>
    </message>
    <message>
        <source>Convex hull of branch</source>
        <translation>Enveloppe convexe de la branche</translation>
    </message>
</context>
<context>
    <name>espalier::IgnoringSteps</name>
    <message>
        <source>Undone: %1</source>
        <translation>Annulé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Redone: %1</source>
        <translation>Rétabli&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>espalier::InspectorFlow</name>
    <message>
        <source>Inspector</source>
        <translation>Inspecteur</translation>
    </message>
    <message>
        <source>Shows or hides this panel</source>
        <translation>Affiche ou masque ce panneau</translation>
    </message>
</context>
<context>
    <name>espalier::InspectorPanel</name>
    <message>
        <source>Inspector</source>
        <translation>Inspecteur</translation>
    </message>
    <message>
        <source>&lt; axial</source>
        <translation>&lt; axiale</translation>
    </message>
    <message>
        <source>+ branching</source>
        <translation>+ ramification</translation>
    </message>
    <message>
        <source>Select the parent</source>
        <translation>Sélectionner le parent</translation>
    </message>
    <message>
        <source>Where the radius is from. The true one lies between these bounds with a probability of 90 %, if they are known.</source>
        <translation>D’où vient le rayon. Le vrai se trouve entre ces bornes avec une probabilité de 90 %, si elles sont connues.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Arête</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordre</translation>
    </message>
    <message>
        <source>Parent</source>
        <translation>Parent</translation>
    </message>
    <message>
        <source>Children</source>
        <translation>Enfants</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Node %1</source>
        <translation>Nœud %1</translation>
    </message>
    <message>
        <source>root</source>
        <translation>racine</translation>
    </message>
    <message>
        <source>%1 nodes</source>
        <translation>%1 nœuds</translation>
    </message>
    <message>
        <source>Mean radius</source>
        <translation>Rayon moyen</translation>
    </message>
    <message>
        <source>The radii differ. A number typed here becomes the radius of all of them.</source>
        <translation>Les rayons diffèrent. Un nombre saisi ici devient le rayon de tous.</translation>
    </message>
    <message>
        <source>Click a node to see it here, or press an arrow key.
Shift+click adds more.</source>
        <translation>Cliquez un nœud pour le voir ici, ou appuyez sur une flèche.
Maj+clic en ajoute d’autres.</translation>
    </message>
</context>
<context>
    <name>espalier::JobSlot</name>
    <message>
        <source>%1 is still running: wait for it, or cancel it</source>
        <translation>%1&#xa0;: encore en cours&#xa0;; attendez la fin, ou annulez</translation>
    </message>
</context>
<context>
    <name>espalier::JudgeFlow</name>
    <message>
        <source>Preview in Numbers</source>
        <translation>Aperçu en chiffres</translation>
    </message>
    <message>
        <source>Shows or hides the numbers by which a preview is judged</source>
        <translation>Affiche ou masque les nombres d’après lesquels on juge un aperçu</translation>
    </message>
    <message>
        <source>What the histogram shows</source>
        <translation>Ce que montre l’histogramme</translation>
    </message>
    <message>
        <source>Residual thickness</source>
        <translation>Épaisseur résiduelle</translation>
    </message>
    <message>
        <source>Distance from the axis</source>
        <translation>Distance à l’axe</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>Déplacement</translation>
    </message>
    <message>
        <source>Relative density</source>
        <translation>Densité relative</translation>
    </message>
    <message>
        <source>Quality of directions</source>
        <translation>Qualité des directions</translation>
    </message>
    <message>
        <source>Radius of nodes</source>
        <translation>Rayon des nœuds</translation>
    </message>
    <message>
        <source>Plant</source>
        <translation>Plante</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>Preview, in the ball</source>
        <translation>Aperçu, dans la boule</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>the preview is not of the whole scan yet: wait a moment</source>
        <translation>l’aperçu n’est pas encore celui du scan entier&#xa0;: attendez un instant</translation>
    </message>
    <message>
        <source>all as usual</source>
        <translation>tout comme d’habitude</translation>
    </message>
    <message>
        <source> and </source>
        <translation> et </translation>
    </message>
    <message>
        <source>spacings</source>
        <translation>espacements</translation>
    </message>
    <message>
        <source>0 thinnest, 1 densest</source>
        <translation>0 le plus épars, 1 le plus dense</translation>
    </message>
    <message>
        <source>0 none, 1 a line</source>
        <translation>0 aucune, 1 une ligne</translation>
    </message>
    <message>
        <source>median %1</source>
        <translation>médiane %1</translation>
    </message>
    <message>
        <source>Turn on Live Preview, or reconstruct, to judge what comes of it</source>
        <translation>Activez l’aperçu en direct, ou reconstruisez, pour juger de ce que cela donne</translation>
    </message>
    <message>
        <source>Bars: %1. Outline: %2.</source>
        <translation>Barres&#xa0;: %1. Contour&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Dashed: the number of the table.</source>
        <translation>En tirets&#xa0;: le nombre du tableau.</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>Calcul en cours…</translation>
    </message>
    <message>
        <source>Drag to select those points.</source>
        <translation>Glissez pour sélectionner ces points.</translation>
    </message>
</context>
<context>
    <name>espalier::JudgeTable</name>
    <message>
        <source>Less is better.</source>
        <translation>Moins, c’est mieux.</translation>
    </message>
    <message>
        <source>More is better.</source>
        <translation>Plus, c’est mieux.</translation>
    </message>
    <message>
        <source>Numbers to judge by</source>
        <translation>Nombres pour juger</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>%1, %2 against %3</source>
        <translation>%1, %2 par rapport à %3</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
</context>
<context>
    <name>espalier::KeyEdit</name>
    <message>
        <source>Press the new keys</source>
        <translation>Pressez les nouvelles touches</translation>
    </message>
</context>
<context>
    <name>espalier::KeysDialog</name>
    <message>
        <source>Set</source>
        <translation>Définir</translation>
    </message>
    <message>
        <source>No Keys</source>
        <translation>Aucune touche</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Réinitialiser</translation>
    </message>
    <message>
        <source>Reset All</source>
        <translation>Tout réinitialiser</translation>
    </message>
    <message>
        <source>Change Keys</source>
        <translation>Modifier les touches</translation>
    </message>
    <message>
        <source>Filter of the commands</source>
        <translation>Filtre des commandes</translation>
    </message>
    <message>
        <source>Filter by name or keys</source>
        <translation>Filtrer par nom ou touches</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>Les commandes et leurs touches</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>New keys</source>
        <translation>Nouvelles touches</translation>
    </message>
    <message>
        <source>Move Here</source>
        <translation>Déplacer ici</translation>
    </message>
    <message>
        <source>This key stays as it is</source>
        <translation>Cette touche reste telle quelle</translation>
    </message>
    <message>
        <source>%1 stays with “%2”: press others</source>
        <translation>%1 reste à «&#xa0;%2&#xa0;»&#xa0;: pressez-en d’autres</translation>
    </message>
    <message>
        <source>%1 is used for “%2”, which would lose it</source>
        <translation>%1 sert à «&#xa0;%2&#xa0;», qui la perdrait</translation>
    </message>
    <message>
        <source>Go to the field and press the new keys</source>
        <translation>Allez dans le champ et appuyez sur les nouvelles touches</translation>
    </message>
</context>
<context>
    <name>espalier::KindFlow</name>
    <message>
        <source>Settings of the Steps</source>
        <translation>Réglages des étapes</translation>
    </message>
    <message>
        <source>Settings for This Plant</source>
        <translation>Réglages pour cette plante</translation>
    </message>
    <message>
        <source>Takes the settings for what the plant of the scan probably is, as the panel of the pipeline says</source>
        <translation>Prend les réglages pour ce qu’est probablement la plante du scan, comme le dit le panneau de la chaîne de traitement</translation>
    </message>
    <message>
        <source>Looking at the plant</source>
        <translation>Examen de la plante</translation>
    </message>
    <message>
        <source>nothing is known of the plant: open a scan</source>
        <translation>rien n’est connu de la plante&#xa0;: ouvrez un scan</translation>
    </message>
    <message>
        <source>Perhaps: %1</source>
        <translation>Peut-être&#xa0;: %1</translation>
    </message>
    <message>
        <source>A guess that is good for simulated plants and often wrong for real ones: other settings are under Skeleton &gt; Settings of the Steps.

Of its points, %1 % are of wood, %2 % of petioles, %3 % of blades and %4 % of needles, as far as their shapes show</source>
        <translation>Une supposition bonne pour les plantes simulées et souvent fausse pour les vraies&#xa0;: d’autres réglages se trouvent sous Squelette &gt; Réglages des étapes.

De ses points, %1 % sont de bois, %2 % de pétioles, %3 % de limbes et %4 % d’aiguilles, autant que leurs formes le montrent</translation>
    </message>
    <message>
        <source>Perhaps: %1. The settings are those for it</source>
        <translation>Peut-être&#xa0;: %1. Les réglages sont déjà ceux qui conviennent</translation>
    </message>
</context>
<context>
    <name>espalier::LanguageFlow</name>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>Changes the language of the window when Espalier starts again</source>
        <translation>Change la langue de la fenêtre au prochain démarrage d’Espalier</translation>
    </message>
    <message>
        <source>As the System</source>
        <translation>Comme le système</translation>
    </message>
    <message>
        <source>The language changes when Espalier starts again</source>
        <translation>La langue change au prochain démarrage d’Espalier</translation>
    </message>
</context>
<context>
    <name>espalier::MainWindow</name>
    <message>
        <source>Canceled: nothing has changed</source>
        <translation>Annulé&#xa0;: rien n’a changé</translation>
    </message>
    <message>
        <source>; what was done until then is saved in %1</source>
        <translation>&#xa0;; ce qui était fait jusque-là est enregistré dans %1</translation>
    </message>
    <message>
        <source>Go On With It</source>
        <translation>Poursuivre</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source> (read-only)</source>
        <translation> (lecture seule)</translation>
    </message>
    <message>
        <source>1 pt</source>
        <translation>1 pt</translation>
    </message>
    <message>
        <source>%1 pts</source>
        <translation>%1 pts</translation>
    </message>
    <message>
        <source>1 node</source>
        <translation>1 nœud</translation>
    </message>
    <message>
        <source>%1 nodes</source>
        <translation>%1 nœuds</translation>
    </message>
    <message>
        <source>%1 set aside</source>
        <translation>%1 mis de côté</translation>
    </message>
    <message>
        <source>1 vertex</source>
        <translation>1 sommet</translation>
    </message>
    <message>
        <source>%1 vertices</source>
        <translation>%1 sommets</translation>
    </message>
    <message>
        <source>Open a scan, or drop one here</source>
        <translation>Ouvrez un scan, ou déposez-en un ici</translation>
    </message>
    <message>
        <source>No positions, so no view   {export_structure} write as MTG or OPF   {open} open another file</source>
        <translation>Pas de positions, donc pas de vue   {export_structure} écrire en MTG ou OPF   {open} ouvrir un autre fichier</translation>
    </message>
    <message>
        <source>Reset Layout</source>
        <translation>Rétablir la disposition</translation>
    </message>
    <message>
        <source>Puts all panels back in their places</source>
        <translation>Remet tous les panneaux à leur place</translation>
    </message>
    <message>
        <source>Color Scales</source>
        <translation>Échelles de couleurs</translation>
    </message>
    <message>
        <source>Colors of Points</source>
        <translation>Couleurs des points</translation>
    </message>
    <message>
        <source>Colors of Nodes</source>
        <translation>Couleurs des nœuds</translation>
    </message>
    <message>
        <source>Color Points By</source>
        <translation>Colorer les points selon</translation>
    </message>
    <message>
        <source>Color Nodes By</source>
        <translation>Colorer les nœuds selon</translation>
    </message>
    <message>
        <source>Point Size</source>
        <translation>Taille des points</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Projection</translation>
    </message>
    <message>
        <source>Look From</source>
        <translation>Regarder depuis</translation>
    </message>
    <message>
        <source>Second View</source>
        <translation>Seconde vue</translation>
    </message>
    <message>
        <source>Saved Views</source>
        <translation>Vues enregistrées</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Panneaux</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thème</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>R&amp;oot and Up</source>
        <translation>Raci&amp;ne et haut</translation>
    </message>
    <message>
        <source>Se&amp;ttings of the Steps</source>
        <translation>Réglages des é&amp;tapes</translation>
    </message>
    <message>
        <source>Pre&amp;view</source>
        <translation>A&amp;perçu</translation>
    </message>
    <message>
        <source>&amp;Units</source>
        <translation>&amp;Unités</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Ouvrir un fichier &amp;récent</translation>
    </message>
    <message>
        <source>&amp;Worklist</source>
        <translation>&amp;Liste de travail</translation>
    </message>
    <message>
        <source>&amp;Versions</source>
        <translation>&amp;Versions</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation>Ca&amp;lage</translation>
    </message>
    <message>
        <source>Se&amp;lect</source>
        <translation>Sé&amp;lection</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Vue</translation>
    </message>
    <message>
        <source>&amp;Points</source>
        <translation>&amp;Points</translation>
    </message>
    <message>
        <source>&amp;Organ</source>
        <translation>&amp;Organe</translation>
    </message>
    <message>
        <source>Several Scans</source>
        <translation>Plusieurs scans</translation>
    </message>
    <message>
        <source>&amp;Skeleton</source>
        <translation>&amp;Squelette</translation>
    </message>
    <message>
        <source>R&amp;adius</source>
        <translation>R&amp;ayon</translation>
    </message>
    <message>
        <source>Eval&amp;uate</source>
        <translation>Éval&amp;uation</translation>
    </message>
    <message>
        <source>&amp;Review</source>
        <translation>&amp;Révision</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Calques</translation>
    </message>
    <message>
        <source>Color By</source>
        <translation>Colorer selon</translation>
    </message>
    <message>
        <source>Espalier crashed on %1. What happened is in %2</source>
        <translation>Espalier s’est arrêté brutalement le %1. Ce qui s’est passé est dans %2</translation>
    </message>
    <message>
        <source>Turn, Move and Zoom</source>
        <translation>Tourner, déplacer et zoomer</translation>
    </message>
</context>
<context>
    <name>espalier::ManualWindow</name>
    <message>
        <source>Manual</source>
        <translation>Manuel</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>◂ Back</source>
        <translation>◂ Retour</translation>
    </message>
    <message>
        <source>Forward ▸</source>
        <translation>Suivant ▸</translation>
    </message>
    <message>
        <source>Nothing has all of these words</source>
        <translation>Rien ne contient tous ces mots</translation>
    </message>
    <message>
        <source>en</source>
        <comment>the folder of the chapters in this language: fr</comment>
        <translation>fr</translation>
    </message>
</context>
<context>
    <name>espalier::MeasureTool</name>
    <message>
        <source>Click two nodes, edges or points: the distance between them   Drag: turn</source>
        <translation>Cliquer deux nœuds, arêtes ou points&#xa0;: la distance entre eux   Glisser&#xa0;: tourner</translation>
    </message>
    <message>
        <source>Click the other end   Esc: leave it</source>
        <translation>Cliquer l’autre bout   Échap&#xa0;: laisser</translation>
    </message>
    <message>
        <source>%1   Click: the angle at the second   {copy} copy   Esc: clear</source>
        <translation>%1   Cliquer&#xa0;: l’angle au deuxième   {copy} copier   Échap&#xa0;: effacer</translation>
    </message>
    <message>
        <source>%1   Click: measure something else   {copy} copy   Esc: clear</source>
        <translation>%1   Cliquer&#xa0;: mesurer autre chose   {copy} copier   Échap&#xa0;: effacer</translation>
    </message>
    <message>
        <source>angle %1°</source>
        <translation>angle %1°</translation>
    </message>
    <message>
        <source>straight %1</source>
        <translation>en ligne droite %1</translation>
    </message>
    <message>
        <source>along the plant %1</source>
        <translation>le long de la plante %1</translation>
    </message>
    <message>
        <source>in different trees</source>
        <translation>dans des arbres différents</translation>
    </message>
</context>
<context>
    <name>espalier::MeasuresForm</name>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (%2 à %3)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>%1, the widest %2</source>
        <translation>%1, le plus large %2</translation>
    </message>
    <message>
        <source>points %1 apart</source>
        <translation>points à %1 l’un de l’autre</translation>
    </message>
    <message>
        <source>wood %1</source>
        <translation>bois %1</translation>
    </message>
    <message>
        <source>scatter %1</source>
        <translation>dispersion %1</translation>
    </message>
    <message>
        <source>Points apart</source>
        <translation>Écart des points</translation>
    </message>
    <message>
        <source>From a point to the nearest other: for half of the points it is less than the first number; for a tenth it is less than the second, and for a tenth more than the third. Point spacings of options are their mean, %1.</source>
        <translation>D’un point à l’autre le plus proche&#xa0;: pour la moitié des points, il est inférieur au premier nombre&#xa0;; pour un dixième, inférieur au deuxième, et pour un dixième, supérieur au troisième. Les espacements de points des options sont leur moyenne, %1.</translation>
    </message>
    <message>
        <source>Scatter</source>
        <translation>Dispersion</translation>
    </message>
    <message>
        <source>%1, %2 spacings</source>
        <translation>%1, %2 espacements</translation>
    </message>
    <message>
        <source>How far points lie off the surface of the wood (standard deviation): the noise of the scan</source>
        <translation>À quelle distance de la surface du bois se trouvent les points (écart-type)&#xa0;: le bruit du scan</translation>
    </message>
    <message>
        <source>Wood is thick</source>
        <translation>Épaisseur du bois</translation>
    </message>
    <message>
        <source>How thick the wood around points is, noise included: at half of them less than the first number; at a tenth less than the second, and at a tenth more than the third. It was measured at %1 of the points: elsewhere the wood branches, is close to other wood, or is more than some 16 point spacings thick.</source>
        <translation>L’épaisseur du bois autour des points, bruit compris&#xa0;: pour la moitié d’entre eux, inférieure au premier nombre&#xa0;; pour un dixième, inférieure au deuxième, et pour un dixième, supérieure au troisième. Elle a été mesurée à %1 des points&#xa0;: ailleurs, le bois se ramifie, est proche d’un autre bois, ou a une épaisseur de plus de quelque 16 espacements de points.</translation>
    </message>
    <message>
        <source>Seen around</source>
        <translation>Vu autour</translation>
    </message>
    <message>
        <source>How far around wood there are points, where it is at least 3 point spacings thick: 360° is all around</source>
        <translation>Jusqu’où il y a des points autour du bois, là où il a une épaisseur d’au moins 3 espacements de points&#xa0;: 360°, c’est tout autour</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>Lacunes</translation>
    </message>
    <message>
        <source>Places wider than 8 point spacings without points, which part the plant</source>
        <translation>Endroits de plus de 8 espacements de points sans aucun point, qui séparent la plante</translation>
    </message>
    <message>
        <source>Foliage</source>
        <translation>Feuillage</translation>
    </message>
    <message>
        <source>%1 of the points</source>
        <translation>%1 des points</translation>
    </message>
    <message>
        <source>Points that look like those of leaves and needles. The step Leaves leaves them out.</source>
        <translation>Points qui ressemblent à ceux de feuilles et d’aiguilles. L’étape Feuilles les écarte.</translation>
    </message>
    <message>
        <source>What the scan is like</source>
        <translation>Caractéristiques du scan</translation>
    </message>
    <message>
        <source>What is measured on the points: how far they are apart, how they scatter, how thick the wood is, how far around it was seen, gaps and foliage</source>
        <translation>Ce qui est mesuré sur les points&#xa0;: leur écart, leur dispersion, l’épaisseur du bois, jusqu’où il a été vu tout autour, les lacunes et le feuillage</translation>
    </message>
    <message>
        <source>being measured…</source>
        <translation>mesure en cours…</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>Where the slab begins, along the axis that points up</source>
        <translation>Où commence la tranche, le long de l’axe dirigé vers le haut</translation>
    </message>
    <message>
        <source>Apart</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>From a point to the nearest other, median</source>
        <translation>D’un point à l’autre le plus proche, médiane</translation>
    </message>
    <message>
        <source>How far points lie off the surface of the wood</source>
        <translation>À quelle distance de la surface du bois se trouvent les points</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>Bois</translation>
    </message>
    <message>
        <source>How thick the wood is, median</source>
        <translation>L’épaisseur du bois, médiane</translation>
    </message>
    <message>
        <source>Share of the points that look like those of leaves and needles</source>
        <translation>Part des points qui ressemblent à ceux de feuilles et d’aiguilles</translation>
    </message>
</context>
<context>
    <name>espalier::MessageBanner</name>
    <message>
        <source>Dismiss</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>espalier::MethodForm</name>
    <message>
        <source>Source: %1</source>
        <translation>Source&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>espalier::MethodsFlow</name>
    <message>
        <source>Methods</source>
        <translation>Méthodes</translation>
    </message>
    <message>
        <source>Table of Methods</source>
        <translation>Tableau des méthodes</translation>
    </message>
    <message>
        <source>Shows or hides how other structures agree with the reference</source>
        <translation>Affiche ou masque l’accord d’autres structures avec la référence</translation>
    </message>
    <message>
        <source>Add structures to compare</source>
        <translation>Ajouter des structures à comparer</translation>
    </message>
    <message>
        <source>%1 is not where it was: these are the numbers that were kept</source>
        <translation>%1 n’est plus à sa place&#xa0;: voici les nombres qui avaient été gardés</translation>
    </message>
    <message>
        <source>Compare %1</source>
        <translation>Comparer&#xa0;: %1</translation>
    </message>
    <message>
        <source>The plant</source>
        <translation>La plante</translation>
    </message>
    <message>
        <source>Copied the table of methods</source>
        <translation>Tableau des méthodes copié</translation>
    </message>
</context>
<context>
    <name>espalier::MethodsPanel</name>
    <message>
        <source>Add Structures…</source>
        <translation>Ajouter des structures…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Copy Table</source>
        <translation>Copier le tableau</translation>
    </message>
    <message>
        <source>Takes the selected structures out of the table</source>
        <translation>Retire du tableau les structures sélectionnées</translation>
    </message>
    <message>
        <source>Copies the table for a spreadsheet</source>
        <translation>Copie le tableau pour un tableur</translation>
    </message>
    <message>
        <source>Structures compared with the reference</source>
        <translation>Structures comparées avec la référence</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Structure</translation>
    </message>
    <message>
        <source>Load a reference first: each structure is compared with it</source>
        <translation>Chargez d’abord une référence&#xa0;: chaque structure est comparée avec elle</translation>
    </message>
    <message>
        <source>Add structures of other methods or experts to compare them with %1, too</source>
        <translation>Ajoutez des structures d’autres méthodes ou d’autres experts pour les comparer aussi avec %1</translation>
    </message>
    <message>
        <source>Compared with %1 within %2</source>
        <translation>Comparées avec %1, à %2 près</translation>
    </message>
    <message>
        <source>Compared with %1</source>
        <translation>Comparé avec %1</translation>
    </message>
    <message>
        <source>Comparing…</source>
        <translation>Comparaison…</translation>
    </message>
</context>
<context>
    <name>espalier::Minimap</name>
    <message>
        <source>Minimap</source>
        <translation>Vue d’ensemble</translation>
    </message>
    <message>
        <source>All of the plant; drag the frame to move the view</source>
        <translation>La plante entière&#xa0;; glisser le cadre pour déplacer la vue</translation>
    </message>
</context>
<context>
    <name>espalier::MoveNodeTool</name>
    <message>
        <source>Put back. Release the button</source>
        <translation>Remis en place. Relâchez le bouton</translation>
    </message>
    <message>
        <source>Click: select %1   Drag: turn   Right drag: pan</source>
        <translation>Cliquer&#xa0;: sélectionner (%1)   Glisser&#xa0;: tourner   Bouton droit&#xa0;: déplacer</translation>
    </message>
    <message numerus="yes">
        <source>Drag: move the %n nodes   Click: select this one alone   Shift+click: leave it out   {new_child} new child   {tool_reparent} reparent   {remove} remove</source>
        <translation>
            <numerusform>Glisser&#xa0;: déplacer %n nœud   Cliquer&#xa0;: ne sélectionner que lui   Maj+clic&#xa0;: l’en retirer   {new_child} nouvel enfant   {tool_reparent} rattacher   {remove} supprimer</numerusform>
            <numerusform>Glisser&#xa0;: déplacer les %n nœuds   Cliquer&#xa0;: ne sélectionner que celui-ci   Maj+clic&#xa0;: l’en retirer   {new_child} nouvel enfant   {tool_reparent} rattacher   {remove} supprimer</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag: move %1   {new_child} new child   {split_edge} split edge   {tool_reparent} reparent   {remove} remove</source>
        <translation>Glisser&#xa0;: déplacer (%1)   {new_child} nouvel enfant   {split_edge} scinder l’arête   {tool_reparent} rattacher   {remove} supprimer</translation>
    </message>
    <message>
        <source>Click: select %1   Drag: move it   {new_child} new child   {split_edge} split edge   {tool_reparent} reparent   {remove} remove</source>
        <translation>Cliquer&#xa0;: sélectionner (%1)   Glisser&#xa0;: déplacer   {new_child} nouvel enfant   {split_edge} scinder l’arête   {tool_reparent} rattacher   {remove} supprimer</translation>
    </message>
    <message>
        <source>Click: select %1   {split_edge}: split the edge here   Drag: turn   Right drag: pan</source>
        <translation>Cliquer&#xa0;: sélectionner (%1)   {split_edge}&#xa0;: scinder l’arête ici   Glisser&#xa0;: tourner   Bouton droit&#xa0;: déplacer</translation>
    </message>
    <message>
        <source>Drag: turn   Right drag: pan   Wheel: zoom   Click a node: select it   Shift+drag: box   Alt+drag: lasso</source>
        <translation>Glisser&#xa0;: tourner   Bouton droit&#xa0;: déplacer   Molette&#xa0;: zoomer   Cliquer un nœud&#xa0;: le sélectionner   Maj+glisser&#xa0;: boîte   Alt+glisser&#xa0;: lasso</translation>
    </message>
    <message>
        <source>Release: leave it here   Esc: put it back</source>
        <translation>Relâcher&#xa0;: laisser ici   Échap&#xa0;: remettre en place</translation>
    </message>
    <message>
        <source>Release: leave them here   Esc: put them back</source>
        <translation>Relâcher&#xa0;: les laisser ici   Échap&#xa0;: les remettre en place</translation>
    </message>
    <message>
        <source>Along its axis</source>
        <translation>Le long de son axe</translation>
    </message>
    <message>
        <source>On the contracted points</source>
        <translation>Sur les points contractés</translation>
    </message>
    <message>
        <source>No contracted points: reconstruct first</source>
        <translation>Pas de points contractés&#xa0;: reconstruisez d’abord</translation>
    </message>
    <message>
        <source>In the middle of its section</source>
        <translation>Au milieu de sa section</translation>
    </message>
    <message>
        <source>Each in the middle of its section</source>
        <translation>Chacun au milieu de sa section</translation>
    </message>
    <message>
        <source>Shift: along its axis</source>
        <translation>Maj&#xa0;: le long de son axe</translation>
    </message>
    <message>
        <source>Ctrl: to the section center</source>
        <translation>Ctrl&#xa0;: vers le centre de la section</translation>
    </message>
    <message>
        <source>Ctrl: freely</source>
        <translation>Ctrl&#xa0;: librement</translation>
    </message>
    <message>
        <source>Nothing selected. Release the button</source>
        <translation>Rien n’est sélectionné. Relâchez le bouton</translation>
    </message>
    <message>
        <source>Release: select the nodes inside, with Shift in addition   Esc: leave it</source>
        <translation>Relâcher&#xa0;: sélectionner les nœuds à l’intérieur, en plus avec Maj   Échap&#xa0;: laisser</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Déplacer&#xa0;: %1</translation>
    </message>
    <message numerus="yes">
        <source>Move %n nodes</source>
        <translation>
            <numerusform>Déplacer %n nœud</numerusform>
            <numerusform>Déplacer %n nœuds</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>espalier::NavigateTool</name>
    <message>
        <source>Drag: turn   Right drag: pan   Wheel: zoom   Double click: turn around this place</source>
        <translation>Glisser&#xa0;: tourner   Bouton droit&#xa0;: déplacer   Molette&#xa0;: zoomer   Double clic&#xa0;: tourner autour d’ici</translation>
    </message>
</context>
<context>
    <name>espalier::NodeTableFlow</name>
    <message>
        <source>Edit</source>
        <translation>Édition</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copier</translation>
    </message>
    <message>
        <source>Copies the selected nodes as a table, or what was measured</source>
        <translation>Copie les nœuds sélectionnés sous forme de tableau, ou ce qui a été mesuré</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Node Table</source>
        <translation>Tableau des nœuds</translation>
    </message>
    <message>
        <source>Shows or hides the table of nodes</source>
        <translation>Affiche ou masque le tableau des nœuds</translation>
    </message>
    <message>
        <source>Make %1 axial</source>
        <translation>Passer en axe&#xa0;: %1</translation>
    </message>
    <message>
        <source>Make %1 branching</source>
        <translation>Passer en ramification&#xa0;: %1</translation>
    </message>
    <message>
        <source>Copied: %1</source>
        <translation>Copié&#xa0;: %1</translation>
    </message>
    <message>
        <source>select the nodes to copy first</source>
        <translation>sélectionnez d’abord les nœuds à copier</translation>
    </message>
    <message>
        <source>Copied %1 as a table</source>
        <translation>%1&#xa0;: copié sous forme de tableau</translation>
    </message>
    <message>
        <source>Copied 1 row</source>
        <translation>1 ligne copiée</translation>
    </message>
    <message numerus="yes">
        <source>Copied %n rows</source>
        <translation>
            <numerusform>%n ligne copiée</numerusform>
            <numerusform>%n lignes copiées</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>espalier::NodeTableModel</name>
    <message>
        <source>Double click: change it</source>
        <translation>Double clic&#xa0;: modifier</translation>
    </message>
    <message>
        <source>“%1” is no radius: type a number that is 0 or more</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un rayon&#xa0;: saisissez un nombre égal ou supérieur à 0</translation>
    </message>
</context>
<context>
    <name>espalier::NodeTablePanel</name>
    <message>
        <source>Selected only</source>
        <translation>Sélection seule</translation>
    </message>
    <message>
        <source>Filter of the nodes</source>
        <translation>Filtre des nœuds</translation>
    </message>
    <message>
        <source>Filter: radius &gt; 10 and order = 2, or a text</source>
        <translation>Filtre&#xa0;: rayon &gt; 10 et ordre = 2, ou un texte</translation>
    </message>
    <message>
        <source>Copy Table</source>
        <translation>Copier le tableau</translation>
    </message>
    <message>
        <source>Copies the selected rows, or all, for a spreadsheet</source>
        <translation>Copie les lignes sélectionnées, ou toutes, pour un tableur</translation>
    </message>
    <message>
        <source>There are no nodes yet</source>
        <translation>Il n’y a pas encore de nœuds</translation>
    </message>
    <message>
        <source>Select nodes to list them</source>
        <translation>Sélectionnez des nœuds pour les lister</translation>
    </message>
    <message>
        <source>%1 of %2 nodes, %3 selected</source>
        <translation>%1 nœuds sur %2, %3 sélectionnés</translation>
    </message>
    <message>
        <source>Node Table</source>
        <translation>Tableau des nœuds</translation>
    </message>
</context>
<context>
    <name>espalier::NumberBox</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>A number from %1</source>
        <translation>Un nombre de %1</translation>
    </message>
    <message>
        <source>%1; also in mm, cm or m</source>
        <translation>%1&#xa0;; aussi en mm, cm ou m</translation>
    </message>
    <message>
        <source>%1; also in mm, cm or m, or as 6 sp (spacings), 0.02 h (heights), 3 th (thicknesses of thin wood), 2 sc (scatters)</source>
        <translation>%1&#xa0;; aussi en mm, cm ou m, ou comme 6 sp (espacements), 0.02 h (hauteurs), 3 th (épaisseurs du bois fin), 2 sc (dispersions)</translation>
    </message>
    <message>
        <source>%1; also as 6 sp (spacings), 0.02 h (heights), 3 th (thicknesses of thin wood), 2 sc (scatters)</source>
        <translation>%1&#xa0;; aussi comme 6 sp (espacements), 0.02 h (hauteurs), 3 th (épaisseurs du bois fin), 2 sc (dispersions)</translation>
    </message>
</context>
<context>
    <name>espalier::NumberField</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>a whole number, %1 to %2</source>
        <translation>un nombre entier, de %1 à %2</translation>
    </message>
</context>
<context>
    <name>espalier::OptionField</name>
    <message>
        <source>Back to the default</source>
        <translation>Revenir à la valeur par défaut</translation>
    </message>
    <message>
        <source>&lt;qt&gt;%1&lt;br&gt;Default: %2&lt;/qt&gt;</source>
        <translation>&lt;qt&gt;%1&lt;br&gt;Par défaut&#xa0;: %2&lt;/qt&gt;</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Set to %1: back to the default</source>
        <translation>Réglé à %1&#xa0;: retour à la valeur par défaut</translation>
    </message>
</context>
<context>
    <name>espalier::OrganFlow</name>
    <message>
        <source>Set to Wood</source>
        <translation>Marquer comme bois</translation>
    </message>
    <message>
        <source>wood</source>
        <translation>bois</translation>
    </message>
    <message>
        <source>Set to Petiole</source>
        <translation>Marquer comme pétiole</translation>
    </message>
    <message>
        <source>petiole</source>
        <translation>pétiole</translation>
    </message>
    <message>
        <source>Set to Blade</source>
        <translation>Marquer comme limbe</translation>
    </message>
    <message>
        <source>blade</source>
        <translation>limbe</translation>
    </message>
    <message>
        <source>Set to Needle</source>
        <translation>Marquer comme aiguille</translation>
    </message>
    <message>
        <source>needle</source>
        <translation>aiguille</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 point</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 points</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>The selected points are of this organ; if none is selected, those that are selected next</source>
        <translation>Les points sélectionnés sont de cet organe&#xa0;; si aucun ne l’est, ceux qui seront sélectionnés ensuite</translation>
    </message>
    <message>
        <source>As It Is Found</source>
        <translation>Tel que trouvé</translation>
    </message>
    <message>
        <source>The organ of the selected points, or if none is selected of all, is not set by hand any more</source>
        <translation>L’organe des points sélectionnés, ou de tous si aucun ne l’est, n’est plus fixé à la main</translation>
    </message>
    <message>
        <source>Set %1 to %2</source>
        <translation>Marquer %1 comme %2</translation>
    </message>
    <message>
        <source>Let the organ of %1 be found</source>
        <translation>Laisser trouver l’organe&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1. The next reconstruction takes it if its step Leaves is on</source>
        <translation>%1. La prochaine reconstruction en tient compte si son étape Feuilles est activée</translation>
    </message>
    <message>
        <source>%1, from the next reconstruction on</source>
        <translation>%1, à partir de la prochaine reconstruction</translation>
    </message>
    <message>
        <source>Canceled: color points by Organ again to find them</source>
        <translation>Annulé&#xa0;: colorez à nouveau les points selon l’organe pour les trouver</translation>
    </message>
    <message>
        <source>%1 organs by hand</source>
        <translation>%1 organes à la main</translation>
    </message>
    <message>
        <source>Finding organs</source>
        <translation>Recherche des organes</translation>
    </message>
    <message>
        <source>Organ</source>
        <translation>Organe</translation>
    </message>
</context>
<context>
    <name>espalier::Overlay</name>
    <message>
        <source>Plant</source>
        <translation>Plante</translation>
    </message>
    <message>
        <source>root</source>
        <translation>racine</translation>
    </message>
    <message>
        <source>Height x</source>
        <translation>Hauteur x</translation>
    </message>
    <message>
        <source>Height y</source>
        <translation>Hauteur y</translation>
    </message>
    <message>
        <source>Height z</source>
        <translation>Hauteur z</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>Intensité</translation>
    </message>
    <message>
        <source>%1, worst</source>
        <translation>%1, pire</translation>
    </message>
</context>
<context>
    <name>espalier::PanelFocus</name>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Go to Panel</source>
        <translation>Aller au panneau</translation>
    </message>
    <message>
        <source>Gives the keyboard to the panel that was used last, once more to the next one; Esc gives it back to the plant</source>
        <translation>Donne le clavier au dernier panneau utilisé, encore une fois au suivant&#xa0;; Échap le rend à la plante</translation>
    </message>
    <message>
        <source>{leave} back to the plant   {go_to_panel} next panel</source>
        <translation>{leave} retour à la plante   {go_to_panel} panneau suivant</translation>
    </message>
    <message>
        <source>No panel is shown that takes keys: View &gt; Panels shows one</source>
        <translation>Aucun panneau affiché ne prend le clavier&#xa0;: Vue &gt; Panneaux en affiche un</translation>
    </message>
    <message>
        <source>{go_to_panel} next panel</source>
        <translation>{go_to_panel} panneau suivant</translation>
    </message>
</context>
<context>
    <name>espalier::PartForm</name>
    <message>
        <source>All points</source>
        <translation>Tous les points</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Au plus</translation>
    </message>
    <message>
        <source>Only what lies in a box</source>
        <translation>Seulement ce qui se trouve dans une boîte</translation>
    </message>
    <message>
        <source>Points from all over the scan, drawn by a lot that always falls alike</source>
        <translation>Des points de tout le scan, tirés au sort, toujours de la même façon</translation>
    </message>
    <message>
        <source>At most so many points</source>
        <translation>Au plus tant de points</translation>
    </message>
    <message>
        <source>%1 from</source>
        <translation>%1 de</translation>
    </message>
    <message>
        <source>%1 to</source>
        <translation>%1 à</translation>
    </message>
    <message>
        <source>to</source>
        <translation>à</translation>
    </message>
    <message>
        <source>The box is empty along %1: its second number is to be the larger one.</source>
        <translation>La boîte est vide le long de %1&#xa0;: son second nombre doit être le plus grand.</translation>
    </message>
    <message>
        <source>about %1 of memory</source>
        <translation>environ %1 de mémoire</translation>
    </message>
    <message>
        <source>from all over it, about %1 of memory</source>
        <translation>pris partout, environ %1 de mémoire</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 points</translation>
    </message>
    <message>
        <source>their number is known once they are read</source>
        <translation>leur nombre est connu une fois qu’ils sont lus</translation>
    </message>
</context>
<context>
    <name>espalier::PickRootTool</name>
    <message>
        <source>Click the foot of the trunk: the plant will be rooted there   Drag: turn   {root_lowest} lowest point   Esc: leave</source>
        <translation>Cliquer le pied du tronc&#xa0;: la plante y aura sa racine   Glisser&#xa0;: tourner   {root_lowest} point le plus bas   Échap&#xa0;: quitter</translation>
    </message>
    <message>
        <source>root here</source>
        <translation>racine ici</translation>
    </message>
    <message>
        <source>there is no scan to choose the root in: open one first</source>
        <translation>il n’y a pas de scan où choisir la racine&#xa0;: ouvrez-en d’abord un</translation>
    </message>
    <message>
        <source>click a point of the scan, at the foot of the trunk</source>
        <translation>cliquez un point du scan, au pied du tronc</translation>
    </message>
</context>
<context>
    <name>espalier::PictureFlow</name>
    <message>
        <source>Save Picture…</source>
        <translation>Enregistrer une image…</translation>
    </message>
    <message>
        <source>Writes what the view shows as a PNG picture, with twice as many pixels as on the screen in each direction</source>
        <translation>Écrit ce que montre la vue dans une image PNG, avec deux fois plus de pixels qu’à l’écran dans chaque direction</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Enregistrer l’image</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>Images PNG (*.png)</translation>
    </message>
    <message>
        <source>%1: pictures are written as PNG: choose a name that ends in .png</source>
        <translation>%1&#xa0;: les images sont écrites en PNG&#xa0;: choisissez un nom qui finit par .png</translation>
    </message>
    <message>
        <source>Wrote %1, %2 × %3 pixels</source>
        <translation>%1 écrit, %2 × %3 pixels</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
</context>
<context>
    <name>espalier::PipelineFlow</name>
    <message>
        <source>Pipeline</source>
        <translation>Chaîne de traitement</translation>
    </message>
    <message>
        <source>Shows or hides this panel</source>
        <translation>Affiche ou masque ce panneau</translation>
    </message>
</context>
<context>
    <name>espalier::PipelinePanel</name>
    <message>
        <source>Live preview</source>
        <translation>Aperçu en direct</translation>
    </message>
    <message>
        <source>Reconstruct</source>
        <translation>Reconstruire</translation>
    </message>
    <message>
        <source>Makes the skeleton from the scan</source>
        <translation>Fait le squelette à partir du scan</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Étapes</translation>
    </message>
    <message>
        <source>Shows what each change of a step would make, at once</source>
        <translation>Montre aussitôt ce que donnerait chaque changement d’une étape</translation>
    </message>
    <message>
        <source>More steps</source>
        <translation>Plus d’étapes</translation>
    </message>
    <message>
        <source>Steps for scans that hold more than one plant: crop, ground, poles, wires, other plants, fewer points; and one that smooths thick wood</source>
        <translation>Étapes pour les scans qui contiennent plus d’une plante&#xa0;: rognage, sol, poteaux, câbles, autres plantes, moins de points&#xa0;; et une qui lisse le gros bois</translation>
    </message>
</context>
<context>
    <name>espalier::PlantView</name>
    <message>
        <source>Plant in 3D</source>
        <translation>Plante en 3D</translation>
    </message>
</context>
<context>
    <name>espalier::PlotFlow</name>
    <message>
        <source>%1… %2 %</source>
        <translation>%1… %2 %</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>Placette</translation>
    </message>
    <message>
        <source>Plot to Plants…</source>
        <translation>De la placette aux plantes…</translation>
    </message>
    <message>
        <source>Finds the plants of a plot and writes each as a project of its own</source>
        <translation>Trouve les plantes d’une placette et écrit chacune comme un projet à part</translation>
    </message>
    <message>
        <source>Finding plants… 0 %</source>
        <translation>Recherche des plantes… 0 %</translation>
    </message>
    <message>
        <source>Finding plants</source>
        <translation>Recherche des plantes</translation>
    </message>
    <message>
        <source>One plant found.</source>
        <translation>Une plante trouvée.</translation>
    </message>
    <message>
        <source>%1 plants found.</source>
        <translation>%1 plantes trouvées.</translation>
    </message>
    <message>
        <source>%1 Of no plant: %2 of %3 points.</source>
        <translation>%1 Sans plante&#xa0;: %2 points sur %3.</translation>
    </message>
    <message>
        <source>Write a project of each plant to a folder</source>
        <translation>Écrire un projet de chaque plante dans un dossier</translation>
    </message>
    <message>
        <source>no plant has a check mark</source>
        <translation>aucune plante n’est cochée</translation>
    </message>
    <message>
        <source>Writing projects… 0 %</source>
        <translation>Écriture des projets… 0 %</translation>
    </message>
    <message>
        <source>Writing projects</source>
        <translation>Écriture des projets</translation>
    </message>
    <message>
        <source>Wrote one project to %1</source>
        <translation>Un projet écrit dans %1</translation>
    </message>
    <message>
        <source>Wrote %1 projects to %2</source>
        <translation>%1 projets écrits dans %2</translation>
    </message>
    <message>
        <source>Show as Worklist</source>
        <translation>Montrer comme liste de travail</translation>
    </message>
</context>
<context>
    <name>espalier::PlotPanel</name>
    <message>
        <source>Finds the stems of a plot and gives each point to the plant that it is of. Each plant becomes a project of its own, in a folder.</source>
        <translation>Trouve les tiges d’une placette et donne chaque point à la plante dont il fait partie. Chaque plante devient un projet à part, dans un dossier.</translation>
    </message>
    <message>
        <source>Plants found</source>
        <translation>Plantes trouvées</translation>
    </message>
    <message>
        <source>Plant</source>
        <translation>Plante</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>A click on a plant selects its points; without its check mark it is not written</source>
        <translation>Un clic sur une plante sélectionne ses points&#xa0;; décochée, elle n’est pas écrite</translation>
    </message>
    <message>
        <source>Leave out ground, poles, wires</source>
        <translation>Écarter sol, poteaux, câbles</translation>
    </message>
    <message>
        <source>Find Plants</source>
        <translation>Trouver les plantes</translation>
    </message>
    <message>
        <source>Write Projects…</source>
        <translation>Écrire les projets…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>By cloth, cylinders and hanging curves, where the pipeline chooses nothing else. Off: only what the pipeline leaves out. Where points were set aside, it is off at first: without ground, a cloth touches branches</source>
        <translation>Par tissu, cylindres et courbes suspendues, là où la chaîne de traitement ne choisit rien d’autre. Décoché&#xa0;: seulement ce que la chaîne de traitement écarte. Si des points ont été mis de côté, c’est d’abord décoché&#xa0;: sans sol, un tissu touche des branches</translation>
    </message>
    <message>
        <source>By the steps of the pipeline before Plant and the options of that step; points that are set aside are of no plant</source>
        <translation>Par les étapes de la chaîne de traitement avant Plante et les options de cette étape&#xa0;; les points mis de côté ne sont d’aucune plante</translation>
    </message>
    <message>
        <source>Chooses a folder, and writes the scan and a project of each plant with a check mark there</source>
        <translation>Choisit un dossier, et y écrit le scan et un projet de chaque plante cochée</translation>
    </message>
</context>
<context>
    <name>espalier::PlotView</name>
    <message>
        <source>Agreement over the tolerance</source>
        <translation>Accord selon la tolérance</translation>
    </message>
    <message>
        <source>Precision, recall and F over the tolerance; drag to choose one</source>
        <translation>Précision, rappel et F selon la tolérance&#xa0;; glisser pour en choisir une</translation>
    </message>
</context>
<context>
    <name>espalier::PointsExportFlow</name>
    <message>
        <source>Export Points…</source>
        <translation>Exporter les points…</translation>
    </message>
    <message>
        <source>Writes the points that are not set aside, as PLY or text</source>
        <translation>Écrit les points qui ne sont pas mis de côté, en PLY ou en texte</translation>
    </message>
    <message>
        <source>Export the points</source>
        <translation>Exporter les points</translation>
    </message>
    <message>
        <source>%1 is the scan itself: choose another name</source>
        <translation>%1 est le scan lui-même&#xa0;: choisissez un autre nom</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>Écriture de %1</translation>
    </message>
    <message>
        <source>Wrote %1: %2 points</source>
        <translation>%1 est écrit&#xa0;: %2 points</translation>
    </message>
</context>
<context>
    <name>espalier::PointsFlow</name>
    <message>
        <source>1 point</source>
        <translation>1 point</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 points</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Next Shape to Select With</source>
        <translation>Forme de sélection suivante</translation>
    </message>
    <message>
        <source>From the brush to boxes, to lassos, and back to the brush</source>
        <translation>Du pinceau aux boîtes, aux lassos, puis de nouveau au pinceau</translation>
    </message>
    <message>
        <source>Larger Brush</source>
        <translation>Pinceau plus grand</translation>
    </message>
    <message>
        <source>The brush that selects points grows by a quarter</source>
        <translation>Le pinceau qui sélectionne les points grandit d’un quart</translation>
    </message>
    <message>
        <source>Smaller Brush</source>
        <translation>Pinceau plus petit</translation>
    </message>
    <message>
        <source>The brush that selects points shrinks by a fifth</source>
        <translation>Le pinceau qui sélectionne les points rapetisse d’un cinquième</translation>
    </message>
    <message>
        <source>Invert Selected Points</source>
        <translation>Inverser les points sélectionnés</translation>
    </message>
    <message>
        <source>Selects all other points that are not set aside</source>
        <translation>Sélectionne tous les autres points qui ne sont pas mis de côté</translation>
    </message>
    <message>
        <source>Deselect Points</source>
        <translation>Désélectionner les points</translation>
    </message>
    <message>
        <source>No point is selected any more</source>
        <translation>Plus aucun point n’est sélectionné</translation>
    </message>
    <message>
        <source>Select with Brush</source>
        <translation>Sélectionner au pinceau</translation>
    </message>
    <message>
        <source>Paint points with a round brush: they are selected</source>
        <translation>Peindre des points avec un pinceau rond&#xa0;: ils sont sélectionnés</translation>
    </message>
    <message>
        <source>Select with Box</source>
        <translation>Sélectionner par boîte</translation>
    </message>
    <message>
        <source>Draw a box: the points in it are selected</source>
        <translation>Tracer une boîte&#xa0;: les points qu’elle contient sont sélectionnés</translation>
    </message>
    <message>
        <source>Select with Lasso</source>
        <translation>Sélectionner au lasso</translation>
    </message>
    <message>
        <source>Draw a line about points: they are selected</source>
        <translation>Tracer une ligne autour de points&#xa0;: ils sont sélectionnés</translation>
    </message>
    <message>
        <source>Select Pole</source>
        <translation>Sélectionner un poteau</translation>
    </message>
    <message>
        <source>Click a pole, a stake or a pipe: all its points are selected</source>
        <translation>Cliquer un poteau, un piquet ou un tuyau&#xa0;: tous ses points sont sélectionnés</translation>
    </message>
    <message>
        <source>Select Wire</source>
        <translation>Sélectionner un câble</translation>
    </message>
    <message>
        <source>Click a wire or a rope at two places: its points between them are selected</source>
        <translation>Cliquer un câble ou une corde à deux endroits&#xa0;: ses points entre eux sont sélectionnés</translation>
    </message>
    <message>
        <source>Select Plant</source>
        <translation>Sélectionner une plante</translation>
    </message>
    <message>
        <source>Click a plant: all points that belong to its stem are selected</source>
        <translation>Cliquer une plante&#xa0;: tous les points qui appartiennent à sa tige sont sélectionnés</translation>
    </message>
    <message>
        <source>Set Points Aside</source>
        <translation>Mettre des points de côté</translation>
    </message>
    <message>
        <source>The selected points take part in nothing until they are brought back</source>
        <translation>Les points sélectionnés ne comptent pour rien jusqu’à ce qu’ils soient repris</translation>
    </message>
    <message>
        <source>Keep Only These Points</source>
        <translation>Ne garder que ces points</translation>
    </message>
    <message>
        <source>Sets all points aside but the selected ones</source>
        <translation>Met de côté tous les points, sauf ceux qui sont sélectionnés</translation>
    </message>
    <message>
        <source>Bring All Back</source>
        <translation>Tout reprendre</translation>
    </message>
    <message>
        <source>All points that are set aside; while they are shown, only those that are selected, if some are</source>
        <translation>Tous les points mis de côté&#xa0;; pendant qu’ils sont affichés, seulement ceux qui sont sélectionnés, s’il y en a</translation>
    </message>
    <message>
        <source>Show What Was Set Aside</source>
        <translation>Afficher ce qui est mis de côté</translation>
    </message>
    <message>
        <source>Draws the points that are set aside, so that they can be selected</source>
        <translation>Dessine les points mis de côté, pour qu’ils puissent être sélectionnés</translation>
    </message>
    <message>
        <source>Isolate Points</source>
        <translation>Isoler les points</translation>
    </message>
    <message>
        <source>Hides all points but the selected ones, until all are shown again</source>
        <translation>Masque tous les points sauf ceux qui sont sélectionnés, jusqu’à ce que tout soit réaffiché</translation>
    </message>
    <message>
        <source>no point is selected: choose Select Points (C), and paint some</source>
        <translation>aucun point n’est sélectionné&#xa0;: choisissez Sélectionner des points (C), et peignez-en quelques-uns</translation>
    </message>
    <message>
        <source>Set %1 aside</source>
        <translation>Mettre %1 de côté</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Keep only %1</source>
        <translation>Ne garder que %1</translation>
    </message>
    <message>
        <source>no selected point is set aside: select some of those, or none</source>
        <translation>aucun point sélectionné n’est mis de côté&#xa0;: sélectionnez-en parmi ceux-là, ou aucun</translation>
    </message>
    <message>
        <source>Bring %1 back</source>
        <translation>Reprendre %1</translation>
    </message>
    <message>
        <source>Bring These Back</source>
        <translation>Reprendre ceux-ci</translation>
    </message>
</context>
<context>
    <name>espalier::PresetFlow</name>
    <message>
        <source>Settings of the Steps</source>
        <translation>Réglages des étapes</translation>
    </message>
    <message>
        <source>Settings: %1</source>
        <translation>Réglages&#xa0;: %1</translation>
    </message>
    <message>
        <source>Keep Settings As…</source>
        <translation>Garder les réglages sous…</translation>
    </message>
    <message>
        <source>Keeps methods and options of all steps under a name in this menu</source>
        <translation>Garde les méthodes et les options de toutes les étapes sous un nom dans ce menu</translation>
    </message>
    <message>
        <source>Open Settings…</source>
        <translation>Ouvrir des réglages…</translation>
    </message>
    <message>
        <source>Takes methods and options of all steps from a file</source>
        <translation>Prend les méthodes et les options de toutes les étapes dans un fichier</translation>
    </message>
    <message>
        <source>Save Settings…</source>
        <translation>Enregistrer les réglages…</translation>
    </message>
    <message>
        <source>Writes methods and options of all steps to a file, for other plants and for the command line</source>
        <translation>Écrit les méthodes et les options de toutes les étapes dans un fichier, pour d’autres plantes et pour la ligne de commande</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Oublier</translation>
    </message>
    <message>
        <source>Keep Settings</source>
        <translation>Garder les réglages</translation>
    </message>
    <message>
        <source>Name, in the menu Settings of the Steps:</source>
        <translation>Nom, dans le menu Réglages des étapes&#xa0;:</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Garder</translation>
    </message>
    <message>
        <source>Kept these settings as %1</source>
        <translation>Réglages gardés sous le nom %1</translation>
    </message>
    <message>
        <source>Open settings</source>
        <translation>Ouvrir des réglages</translation>
    </message>
    <message>
        <source>Settings (*.json)</source>
        <translation>Réglages (*.json)</translation>
    </message>
    <message>
        <source>Save settings</source>
        <translation>Enregistrer les réglages</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 écrit</translation>
    </message>
    <message>
        <source>%1. What is set otherwise now: %2</source>
        <translation>%1. Réglé autrement désormais&#xa0;: %2</translation>
    </message>
    <message>
        <source>Take Back</source>
        <translation>Revenir en arrière</translation>
    </message>
</context>
<context>
    <name>espalier::PreviewFlow</name>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>Live Preview</source>
        <translation>Aperçu en direct</translation>
    </message>
    <message>
        <source>Shows what each change of a step would make</source>
        <translation>Montre ce que donnerait chaque changement d’une étape</translation>
    </message>
    <message>
        <source>Preview Here</source>
        <translation>Aperçu ici</translation>
    </message>
    <message>
        <source>Shows changes at once in the points under the pointer; on empty ground: where one looks, as usual</source>
        <translation>Montre aussitôt les changements dans les points sous le pointeur&#xa0;; dans le vide&#xa0;: là où l’on regarde, comme d’habitude</translation>
    </message>
    <message>
        <source>Dropped: %1</source>
        <translation>Abandonné&#xa0;: %1</translation>
    </message>
    <message>
        <source>Preview   {reconstruct} make it the skeleton   {leave} drop it   {keep_as_a} keep as A</source>
        <translation>Aperçu   {reconstruct} en faire le squelette   {leave} l’abandonner   {keep_as_a} garder comme A</translation>
    </message>
    <message>
        <source>%1 · in the circle</source>
        <translation>%1 · dans le cercle</translation>
    </message>
</context>
<context>
    <name>espalier::ProjectFlow</name>
    <message>
        <source>a plant</source>
        <translation>une plante</translation>
    </message>
    <message>
        <source>%1 is open in another window (%2)</source>
        <translation>%1 est ouvert dans une autre fenêtre (%2)</translation>
    </message>
    <message>
        <source>%1 may only be read</source>
        <translation>%1 est en lecture seule</translation>
    </message>
    <message>
        <source>Open a Copy</source>
        <translation>Ouvrir une copie</translation>
    </message>
    <message>
        <source>Open Read-Only</source>
        <translation>Ouvrir en lecture seule</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Enregistrer le projet</translation>
    </message>
    <message>
        <source>Espalier projects (*.espalier)</source>
        <translation>Projets Espalier (*.espalier)</translation>
    </message>
    <message>
        <source>Saved %1: from now on, each edit is saved as it happens</source>
        <translation>%1 enregistré&#xa0;: désormais, chaque modification est enregistrée aussitôt</translation>
    </message>
    <message>
        <source>Everything is saved in %1</source>
        <translation>Tout est enregistré dans %1</translation>
    </message>
    <message>
        <source>%1 cannot be written: save it elsewhere</source>
        <translation>%1 ne peut pas être écrit&#xa0;: enregistrez-le ailleurs</translation>
    </message>
    <message>
        <source>this plant is in no project yet: save it as one first</source>
        <translation>cette plante n’est encore dans aucun projet&#xa0;: enregistrez-la d’abord comme projet</translation>
    </message>
    <message>
        <source>%1 is %2 now; it was %3</source>
        <translation>%1 fait maintenant %2&#xa0;; c’était %3</translation>
    </message>
    <message>
        <source>Continue with %1</source>
        <translation>Continuer avec %1</translation>
    </message>
    <message>
        <source>Work on this plant was kept: %1</source>
        <translation>Un travail sur cette plante a été gardé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Continuer</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lecture&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 is open read-only: save it as another project to edit that</source>
        <translation>%1 est ouvert en lecture seule&#xa0;: enregistrez-le comme un autre projet pour le modifier</translation>
    </message>
    <message>
        <source>The scan %1 is not where it was</source>
        <translation>Le scan %1 n’est plus à sa place</translation>
    </message>
    <message>
        <source>Find Scan…</source>
        <translation>Trouver le scan…</translation>
    </message>
    <message>
        <source>Save Elsewhere…</source>
        <translation>Enregistrer ailleurs…</translation>
    </message>
    <message>
        <source>there is no scan in a project: save the plant as a project first</source>
        <translation>il n’y a pas de scan dans un projet&#xa0;: enregistrez d’abord la plante comme projet</translation>
    </message>
    <message>
        <source>%1 holds the scan now</source>
        <translation>%1 contient maintenant le scan</translation>
    </message>
    <message>
        <source>%1 no longer holds the scan: compact it to make it smaller</source>
        <translation>%1 ne contient plus le scan&#xa0;: compactez-le pour en réduire la taille</translation>
    </message>
    <message>
        <source>Keeping the scan</source>
        <translation>Mise du scan dans le projet</translation>
    </message>
    <message>
        <source>Looking for the scan</source>
        <translation>Recherche du scan</translation>
    </message>
    <message>
        <source>Find the scan of this project</source>
        <translation>Trouver le scan de ce projet</translation>
    </message>
    <message>
        <source>Your work is kept: %1</source>
        <translation>Votre travail est conservé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Go Back to It</source>
        <translation>Y revenir</translation>
    </message>
    <message>
        <source>%1 is there already: choose that name to replace it</source>
        <translation>%1 existe déjà&#xa0;: choisissez ce nom pour le remplacer</translation>
    </message>
    <message>
        <source>This project is by %1: your steps will be recorded without a name</source>
        <translation>Ce projet est de %1&#xa0;: vos étapes seront notées sans nom</translation>
    </message>
    <message>
        <source>This project is by %1: your steps will be recorded as by %2</source>
        <translation>Ce projet est de %1&#xa0;: vos étapes seront notées comme étant de %2</translation>
    </message>
    <message>
        <source>Go On as %1</source>
        <translation>Continuer comme %1</translation>
    </message>
</context>
<context>
    <name>espalier::RadiusFlow</name>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Set Radius by Circle</source>
        <translation>Définir le rayon par cercle</translation>
    </message>
    <message>
        <source>A circle fitted to the cross-section, which stray points do not pull</source>
        <translation>Un cercle ajusté à la section, que les points isolés ne tirent pas</translation>
    </message>
    <message>
        <source>Set Radius by Mean</source>
        <translation>Définir le rayon par moyenne</translation>
    </message>
    <message>
        <source>Mean distance of the points of the cross-section to the node</source>
        <translation>Distance moyenne des points de la section au nœud</translation>
    </message>
    <message>
        <source>Set Radius by Maximum</source>
        <translation>Définir le rayon par maximum</translation>
    </message>
    <message>
        <source>Greatest distance of a point of the cross-section to the node</source>
        <translation>Plus grande distance d’un point de la section au nœud</translation>
    </message>
    <message>
        <source>Set Radius by Hull</source>
        <translation>Définir le rayon par enveloppe convexe</translation>
    </message>
    <message>
        <source>Perimeter of the convex hull of the cross-section, over 2 pi</source>
        <translation>Périmètre de l’enveloppe convexe de la section, divisé par 2 pi</translation>
    </message>
    <message>
        <source>Pipe Model from Here</source>
        <translation>Modèle des tuyaux à partir d’ici</translation>
    </message>
    <message>
        <source>All that the node carries gets thinner with what it carries</source>
        <translation>Tout ce que porte le nœud s’amincit avec ce qu’il porte</translation>
    </message>
    <message>
        <source>Pipe Model, Keep Measured</source>
        <translation>Modèle des tuyaux, garder le mesuré</translation>
    </message>
    <message>
        <source>The same, but a radius that the points confirm stays</source>
        <translation>De même, mais un rayon que les points confirment reste</translation>
    </message>
    <message>
        <source>Smooth Radii</source>
        <translation>Lisser les rayons</translation>
    </message>
    <message>
        <source>Halfway to the mean of the neighbors on the axis; tapers stay</source>
        <translation>À mi-chemin de la moyenne des voisins sur l’axe&#xa0;; les décroissances restent</translation>
    </message>
    <message>
        <source>Limit Radii by Parent&apos;s</source>
        <translation>Limiter les rayons à celui du parent</translation>
    </message>
    <message>
        <source>No node thicker than its parent</source>
        <translation>Aucun nœud plus gros que son parent</translation>
    </message>
    <message>
        <source>Drag the center or the rim   Arrows, Page Up and Down: the same by keys   Wheel: zoom</source>
        <translation>Glisser le centre ou le bord   Flèches, Page préc. et suiv.&#xa0;: de même au clavier   Molette&#xa0;: zoomer</translation>
    </message>
    <message>
        <source>no node is selected: select some first</source>
        <translation>aucun nœud n’est sélectionné&#xa0;: sélectionnez-en d’abord</translation>
    </message>
    <message>
        <source>there are no points to measure: open the scan first</source>
        <translation>il n’y a pas de points à mesurer&#xa0;: ouvrez d’abord le scan</translation>
    </message>
    <message>
        <source>Measuring radii</source>
        <translation>Mesure des rayons</translation>
    </message>
    <message>
        <source>no radius could be measured: %1. Try another measure, or type a radius</source>
        <translation>aucun rayon n’a pu être mesuré&#xa0;: %1. Essayez une autre mesure, ou saisissez un rayon</translation>
    </message>
    <message>
        <source>Set the radius of %1 by %2</source>
        <translation>Définir le rayon de %1 par %2</translation>
    </message>
    <message>
        <source>Radius by %1: %2 set, %3 as before (%4)</source>
        <translation>Rayon par %1&#xa0;: défini pour %2, %3 comme avant (%4)</translation>
    </message>
    <message>
        <source>Radius by %1: %2 set</source>
        <translation>Rayon par %1&#xa0;: défini pour %2</translation>
    </message>
    <message>
        <source>Pipe model from %1</source>
        <translation>Modèle des tuyaux à partir d’ici&#xa0;: %1</translation>
    </message>
    <message>
        <source>Pipe model from %1, measured radii kept</source>
        <translation>Modèle des tuyaux à partir d’ici, rayons mesurés gardés&#xa0;: %1</translation>
    </message>
    <message>
        <source>Pipe model: %1 kept their radius, which the points confirm</source>
        <translation>Modèle des tuyaux&#xa0;: rayon gardé, car les points le confirment, pour %1</translation>
    </message>
    <message>
        <source>Smooth the radius of %1</source>
        <translation>Lisser le rayon&#xa0;: %1</translation>
    </message>
    <message>
        <source>Limit the radius of %1</source>
        <translation>Limiter le rayon&#xa0;: %1</translation>
    </message>
    <message>
        <source>No selected node is thicker than its parent</source>
        <translation>Aucun nœud sélectionné n’est plus gros que son parent</translation>
    </message>
</context>
<context>
    <name>espalier::ReconstructFlow</name>
    <message>
        <source>Re&amp;construct</source>
        <translation>Re&amp;construire</translation>
    </message>
    <message>
        <source>Makes the skeleton from the scan</source>
        <translation>Fait le squelette à partir du scan</translation>
    </message>
    <message>
        <source>there is no scan to reconstruct from: open one first</source>
        <translation>il n’y a pas de scan à partir duquel reconstruire&#xa0;: ouvrez-en d’abord un</translation>
    </message>
    <message>
        <source>Reconstructing</source>
        <translation>Reconstruction</translation>
    </message>
    <message>
        <source>1 edit by hand</source>
        <translation>1 modification à la main</translation>
    </message>
    <message>
        <source>%1 edits by hand</source>
        <translation>%1 modifications à la main</translation>
    </message>
    <message>
        <source>marks of %1 reviewed nodes</source>
        <translation>les marques de %1 nœuds révisés</translation>
    </message>
    <message>
        <source>Reconstructing replaces the skeleton, with %1. Undo brings it back</source>
        <translation>Reconstruire remplace le squelette, avec %1. Annuler le fait revenir</translation>
    </message>
    <message>
        <source> and </source>
        <translation> et </translation>
    </message>
    <message>
        <source>Reconstruct</source>
        <translation>Reconstruire</translation>
    </message>
    <message>
        <source>Save Project As…</source>
        <translation>Enregistrer le projet sous…</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Last run: %1 s, %2 MB more memory at most</source>
        <translation>Dernière exécution&#xa0;: %1 s, %2 Mo de mémoire de plus au maximum</translation>
    </message>
    <message>
        <source>note</source>
        <translation>note</translation>
    </message>
    <message>
        <source>note, %1</source>
        <translation>note, %1</translation>
    </message>
    <message>
        <source>less than 0.1</source>
        <translation>moins de 0.1</translation>
    </message>
    <message>
        <source>%1 done in %2 s</source>
        <translation>%1&#xa0;: fait en %2 s</translation>
    </message>
    <message>
        <source>1 node reconstructed in %1 s</source>
        <translation>1 nœud reconstruit en %1 s</translation>
    </message>
    <message>
        <source>%1 nodes reconstructed in %2 s</source>
        <translation>%1 nœuds reconstruits en %2 s</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>step, note</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Reconstruct: %1</source>
        <translation>Reconstruire&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>espalier::ReferenceFlow</name>
    <message>
        <source>Evaluate</source>
        <translation>Évaluer</translation>
    </message>
    <message>
        <source>&amp;Load Reference…</source>
        <translation>&amp;Charger une référence…</translation>
    </message>
    <message>
        <source>Loads the structure that the plant is compared with</source>
        <translation>Charge la structure à laquelle la plante est comparée</translation>
    </message>
    <message>
        <source>Remove Reference</source>
        <translation>Retirer la référence</translation>
    </message>
    <message>
        <source>Puts the reference away; its file stays as it is</source>
        <translation>Range la référence&#xa0;; son fichier reste tel quel</translation>
    </message>
    <message>
        <source>%1 is no longer the reference</source>
        <translation>%1 n’est plus la référence</translation>
    </message>
    <message>
        <source>Load the reference</source>
        <translation>Charger la référence</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lecture&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 is the reference now</source>
        <translation>%1 est maintenant la référence</translation>
    </message>
    <message>
        <source>A structure was dropped</source>
        <translation>Une structure a été déposée</translation>
    </message>
    <message>
        <source>&lt;b&gt;Open %1, or compare the plant with it?&lt;/b&gt;</source>
        <translation>&lt;b&gt;Ouvrir %1, ou lui comparer la plante&#xa0;?&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Opened, it takes the place of the skeleton; as the reference, it is shown beside it.</source>
        <translation>Ouverte, elle prend la place du squelette&#xa0;; comme référence, elle est affichée à côté de lui.</translation>
    </message>
    <message>
        <source>Load as Reference</source>
        <translation>Charger comme référence</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>%1 is the reference again</source>
        <translation>%1 est de nouveau la référence</translation>
    </message>
    <message>
        <source>Compare with %1</source>
        <translation>Comparer à %1</translation>
    </message>
    <message>
        <source>Load Reference Beside the Scan</source>
        <translation>Charger la référence à côté du scan</translation>
    </message>
    <message>
        <source>Loads the structure that has the name of the scan and lies beside it, as that of the sample plant</source>
        <translation>Charge la structure qui a le nom du scan et se trouve à côté de lui, comme celle de la plante d’exemple</translation>
    </message>
    <message>
        <source>The plant is compared with “%1”</source>
        <translation>La plante est comparée à «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>espalier::RegistrationFlow</name>
    <message>
        <source>Distance to the open scan</source>
        <translation>Distance au scan ouvert</translation>
    </message>
    <message>
        <source>Registration</source>
        <translation>Recalage</translation>
    </message>
    <message>
        <source>Register Another Scan…</source>
        <translation>Recaler un autre scan…</translation>
    </message>
    <message>
        <source>Lays another scan of this plant on the open one, to join them</source>
        <translation>Pose un autre scan de cette plante sur le scan ouvert, pour les joindre</translation>
    </message>
    <message>
        <source>Fit by Points</source>
        <translation>Ajuster par les points</translation>
    </message>
    <message>
        <source>Moves the other scan until its points lie on those of the open one. Without targets, it may be off by up to about 5° and a tenth of the plant</source>
        <translation>Déplace l’autre scan jusqu’à ce que ses points soient sur ceux du scan ouvert. Sans cibles, l’erreur peut aller jusqu’à environ 5° et un dixième de la plante</translation>
    </message>
    <message>
        <source>Color by Distance</source>
        <translation>Colorer selon la distance</translation>
    </message>
    <message>
        <source>Colors the points of the other scan by how far the open one is: where the two overlap, and how well</source>
        <translation>Colore les points de l’autre scan selon leur distance au scan ouvert&#xa0;: où les deux se recouvrent, et à quel point</translation>
    </message>
    <message>
        <source>Reset Registration</source>
        <translation>Réinitialiser le recalage</translation>
    </message>
    <message>
        <source>Forgets all targets, and puts the other scan where it was at first</source>
        <translation>Oublie toutes les cibles, et remet l’autre scan où il était d’abord</translation>
    </message>
    <message>
        <source>Join…</source>
        <translation>Joindre…</translation>
    </message>
    <message>
        <source>Writes the points of both scans into one file, which the plant has from then on</source>
        <translation>Écrit les points des deux scans dans un fichier, qui est désormais celui de la plante</translation>
    </message>
    <message>
        <source>Move a Structure…</source>
        <translation>Déplacer une structure…</translation>
    </message>
    <message>
        <source>Writes a structure that was made on the other scan where that lies now</source>
        <translation>Écrit une structure faite sur l’autre scan là où celui-ci se trouve maintenant</translation>
    </message>
    <message>
        <source>Leave Registration</source>
        <translation>Quitter le recalage</translation>
    </message>
    <message>
        <source>Puts the other scan away; the plant is as before</source>
        <translation>Range l’autre scan&#xa0;; la plante est comme avant</translation>
    </message>
    <message>
        <source>Shows or hides the targets by which another scan is laid on the open one</source>
        <translation>Affiche ou masque les cibles par lesquelles un autre scan est posé sur le scan ouvert</translation>
    </message>
    <message>
        <source>First pick three pairs of targets, or fit by points</source>
        <translation>Choisissez d’abord trois paires de cibles, ou ajustez par les points</translation>
    </message>
    <message>
        <source>Register another scan of this plant</source>
        <translation>Recaler un autre scan de cette plante</translation>
    </message>
    <message>
        <source>Join the scans</source>
        <translation>Joindre les scans</translation>
    </message>
    <message>
        <source>PLY points (*.ply)</source>
        <translation>Points PLY (*.ply)</translation>
    </message>
    <message>
        <source>A structure that was made on %1</source>
        <translation>Une structure faite sur %1</translation>
    </message>
    <message>
        <source>Write the structure that was moved</source>
        <translation>Écrire la structure déplacée</translation>
    </message>
    <message>
        <source>Fitting %1 by its points</source>
        <translation>Ajustement par les points&#xa0;: %1</translation>
    </message>
    <message>
        <source>Distances to the open scan</source>
        <translation>Distances au scan ouvert</translation>
    </message>
    <message>
        <source>there is no scan to register another one to: open one first</source>
        <translation>il n’y a pas de scan sur lequel en recaler un autre&#xa0;: ouvrez-en d’abord un</translation>
    </message>
    <message>
        <source>   Drag: turn   {remove_last_target} take back   {leave} leave</source>
        <translation>   Glisser&#xa0;: tourner   {remove_last_target} retirer   {leave} quitter</translation>
    </message>
    <message>
        <source>click a point of the open scan (blue)</source>
        <translation>cliquez un point du scan ouvert (bleu)</translation>
    </message>
    <message>
        <source>click a point of %1 (orange)</source>
        <translation>cliquez un point de %1 (orange)</translation>
    </message>
    <message>
        <source>Sphere of radius %1, its points %2 off</source>
        <translation>Sphère de rayon %1, ses points à %2</translation>
    </message>
    <message>
        <source>&lt;b&gt;Leave the registration of %1?&lt;/b&gt;</source>
        <translation>&lt;b&gt;Quitter le recalage de %1&#xa0;?&lt;/b&gt;</translation>
    </message>
    <message>
        <source>The targets that were picked, and where it was moved to, are lost.</source>
        <translation>Les cibles choisies, et le nouvel emplacement du scan, sont perdus.</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Quitter</translation>
    </message>
    <message>
        <source>Go On</source>
        <translation>Continuer</translation>
    </message>
    <message>
        <source>Of all pairs: %1 root mean square</source>
        <translation>Sur toutes les paires&#xa0;: %1 en moyenne quadratique</translation>
    </message>
    <message>
        <source>By points: %1 root mean square across the surfaces, %2 % overlap</source>
        <translation>Par les points&#xa0;: %1 en moyenne quadratique à travers les surfaces, %2 % de recouvrement</translation>
    </message>
    <message>
        <source>Click the same target in %1 (orange)</source>
        <translation>Cliquez la même cible dans %1 (orange)</translation>
    </message>
    <message>
        <source>Click another target in the open scan (blue), or fit by points, or join</source>
        <translation>Cliquez une autre cible dans le scan ouvert (bleu), ou ajustez par les points, ou joignez</translation>
    </message>
    <message>
        <source>Click a target in the open scan (blue)</source>
        <translation>Cliquez une cible dans le scan ouvert (bleu)</translation>
    </message>
    <message>
        <source>The pairs do not fit together: one of them is not the same target in both.</source>
        <translation>Les paires ne s’accordent pas&#xa0;: l’une d’elles n’est pas la même cible dans les deux.</translation>
    </message>
    <message>
        <source>It still moved when it was stopped: pick more targets, and fit again.</source>
        <translation>Il bougeait encore quand il a été arrêté&#xa0;: choisissez d’autres cibles, et ajustez à nouveau.</translation>
    </message>
    <message>
        <source>Little overlaps: look whether it lies well, or pick more targets.</source>
        <translation>Peu se recouvre&#xa0;: regardez s’il est bien posé, ou choisissez d’autres cibles.</translation>
    </message>
    <message>
        <source>colors</source>
        <translation>couleurs</translation>
    </message>
    <message>
        <source>intensities</source>
        <translation>intensités</translation>
    </message>
    <message>
        <source> and </source>
        <translation> et </translation>
    </message>
    <message>
        <source>. Of %1, it holds the part that was read</source>
        <translation>. De %1, il contient la partie qui a été lue</translation>
    </message>
    <message>
        <source> and of </source>
        <translation> et de </translation>
    </message>
    <message>
        <source>%1: scans are joined as PLY: choose a name that ends in .ply</source>
        <translation>%1&#xa0;: les scans sont joints au format PLY&#xa0;: choisissez un nom qui finit par .ply</translation>
    </message>
    <message>
        <source>%1 is one of the two scans: choose another name</source>
        <translation>%1 est l’un des deux scans&#xa0;: choisissez un autre nom</translation>
    </message>
    <message>
        <source>Joining %1</source>
        <translation>Jonction de %1</translation>
    </message>
    <message>
        <source>Join %1</source>
        <translation>Joindre %1</translation>
    </message>
    <message>
        <source>Joined %1: the scan of the plant is %2 now</source>
        <translation>%1 est joint&#xa0;: le scan de la plante est maintenant %2</translation>
    </message>
    <message>
        <source>, without %1, which only one of the two has</source>
        <translation>, sans %1, que seul l’un des deux possède</translation>
    </message>
    <message>
        <source>%1 is the structure to be moved: choose another name</source>
        <translation>%1 est la structure à déplacer&#xa0;: choisissez un autre nom</translation>
    </message>
    <message>
        <source>Moving %1</source>
        <translation>Déplacement de %1</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 écrit</translation>
    </message>
    <message>
        <source>Open It Here</source>
        <translation>L’ouvrir ici</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>Ouvrir %1</translation>
    </message>
    <message>
        <source>Take Back the Last Step</source>
        <translation>Retirer la dernière étape</translation>
    </message>
    <message>
        <source>Takes back the target that was clicked last, the last pair, or the fit by points</source>
        <translation>Retire la dernière cible cliquée, la dernière paire ou l’ajustement par les points</translation>
    </message>
    <message>
        <source>By points, the targets are %1 apart; by pairs alone they were %2. Look which lies better: {undo} takes the fit back.</source>
        <translation>Par les points, les cibles sont à %1 l’une de l’autre&#xa0;; par les paires seules, elles étaient à %2. Regardez ce qui est le mieux placé&#xa0;: {undo} retire l’ajustement.</translation>
    </message>
</context>
<context>
    <name>espalier::RegistrationPanel</name>
    <message>
        <source>Pairs of targets</source>
        <translation>Paires de cibles</translation>
    </message>
    <message>
        <source>Pair</source>
        <translation>Paire</translation>
    </message>
    <message>
        <source>Apart by</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>Targets are spheres</source>
        <translation>Les cibles sont des sphères</translation>
    </message>
    <message>
        <source>Lays another scan of this plant on the open one, by targets that both show and by their points, and joins them.</source>
        <translation>Recale un autre scan de cette plante sur le scan ouvert, par des cibles que les deux montrent et par leurs points, et les joint.</translation>
    </message>
    <message>
        <source>A click anywhere on a sphere is enough: its center is found</source>
        <translation>Un clic n’importe où sur une sphère suffit&#xa0;: son centre est trouvé</translation>
    </message>
    <message>
        <source>Radius of the spheres</source>
        <translation>Rayon des sphères</translation>
    </message>
    <message>
        <source>Radius of the spheres; 0: it is found</source>
        <translation>Rayon des sphères&#xa0;; 0&#xa0;: il est trouvé</translation>
    </message>
    <message>
        <source>found</source>
        <translation>trouvé</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Réinitialiser</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Quitter</translation>
    </message>
    <message>
        <source>Registration</source>
        <translation>Recalage</translation>
    </message>
    <message>
        <source>%1, worst</source>
        <translation>%1, pire</translation>
    </message>
    <message>
        <source>Removes pair %1</source>
        <translation>Supprime la paire %1</translation>
    </message>
</context>
<context>
    <name>espalier::RegrowTool</name>
    <message>
        <source>1 new node</source>
        <translation>1 nouveau nœud</translation>
    </message>
    <message>
        <source>%1 new nodes</source>
        <translation>%1 nouveaux nœuds</translation>
    </message>
    <message>
        <source>Enter accepts, Esc drops</source>
        <translation>Entrée accepte, Échap abandonne</translation>
    </message>
    <message>
        <source>%1: %2 long   {take_branch} takes   {drop_branch} drops   Enter: all   Esc: none</source>
        <translation>%1&#xa0;: %2 de long   {take_branch} prend   {drop_branch} abandonne   Entrée&#xa0;: toutes   Échap&#xa0;: aucune</translation>
    </message>
    <message>
        <source>%1 on %2   %3</source>
        <translation>%1 sur %2   %3</translation>
    </message>
    <message>
        <source>%1 of %2 branches, from %3 on: %4   %5   {fewer_branches} fewer   {more_branches} more</source>
        <translation>%1 branches sur %2, à partir de %3&#xa0;: %4   %5   {fewer_branches} moins   {more_branches} plus</translation>
    </message>
    <message>
        <source>Click a node: what it carries is reconstructed again</source>
        <translation>Cliquer un nœud&#xa0;: ce qu’il porte est reconstruit à nouveau</translation>
    </message>
    <message>
        <source>%1 for the %2 that %3 carries   %4</source>
        <translation>%1 pour les %2 que porte %3   %4</translation>
    </message>
    <message>
        <source>the node is gone: choose another one</source>
        <translation>le nœud a disparu&#xa0;: choisissez-en un autre</translation>
    </message>
    <message>
        <source>Regrow %1</source>
        <translation>Reconstruire à nouveau&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 is gone, which was to carry a branch: drop this, and grow it again</source>
        <translation>%1 a disparu, qui devait porter une branche&#xa0;: abandonnez cela, et reconstruisez-la à nouveau</translation>
    </message>
    <message>
        <source>one node is regrown at a time: select one</source>
        <translation>un seul nœud est reconstruit à nouveau à la fois&#xa0;: sélectionnez-en un</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>branch</comment>
        <translation>%1 sur&#xa0;%2</translation>
    </message>
    <message>
        <source>click a node: what it carries is reconstructed again</source>
        <translation>cliquez un nœud&#xa0;: ce qu’il porte est reconstruit à nouveau</translation>
    </message>
</context>
<context>
    <name>espalier::ReparentNodeTool</name>
    <message>
        <source>Drag a node onto its new parent, or click one after the other</source>
        <translation>Glisser un nœud sur son nouveau parent, ou cliquer l’un puis l’autre</translation>
    </message>
    <message>
        <source>Release: attach %1 to %2   Esc: put it back</source>
        <translation>Relâcher&#xa0;: rattacher %1 → %2   Échap&#xa0;: remettre en place</translation>
    </message>
    <message>
        <source>Release: attach %1 here on the edge   Esc: put it back</source>
        <translation>Relâcher&#xa0;: rattacher ici, sur l’arête (%1)   Échap&#xa0;: remettre en place</translation>
    </message>
    <message>
        <source>Drop %1 on its new parent   Esc: put it back</source>
        <translation>Déposer sur le nouveau parent (%1)   Échap&#xa0;: remettre en place</translation>
    </message>
    <message>
        <source>Click: attach %1 to %2   Esc: leave it</source>
        <translation>Cliquer&#xa0;: rattacher %1 → %2   Échap&#xa0;: laisser</translation>
    </message>
    <message>
        <source>Click: attach %1 here on the edge   Esc: leave it</source>
        <translation>Cliquer&#xa0;: rattacher ici, sur l’arête (%1)   Échap&#xa0;: laisser</translation>
    </message>
    <message>
        <source>Click the new parent of %1   Drag: turn   Esc: leave it</source>
        <translation>Cliquer le nouveau parent (%1)   Glisser&#xa0;: tourner   Échap&#xa0;: laisser</translation>
    </message>
    <message>
        <source>a branch cannot be attached to itself: choose a place outside it</source>
        <translation>une branche ne peut pas être attachée à elle-même&#xa0;: choisissez un endroit hors d’elle</translation>
    </message>
    <message>
        <source>Reparent %1 to %2</source>
        <translation>Rattacher&#xa0;: %1 au nœud %2</translation>
    </message>
    <message>
        <source>Reparent %1 to the edge of %2</source>
        <translation>Rattacher&#xa0;: %1 à une arête (%2)</translation>
    </message>
    <message>
        <source>%1 is what is attached: click the node or edge that it grows from</source>
        <translation>%1 est ce qui est rattaché&#xa0;: cliquez le nœud ou l’arête d’où il part</translation>
    </message>
    <message>
        <source>%1 is one of the %2 nodes that are attached: click the node or edge that they grow from, or press Esc and choose fewer nodes</source>
        <translation>%1 est un des %2 nœuds rattachés&#xa0;: cliquez le nœud ou l’arête d’où ils partent, ou appuyez sur Échap et choisissez moins de nœuds</translation>
    </message>
    <message>
        <source>no node or edge is there to attach %1 to: what points or wood hide is not clicked; turn the plant, or choose Select &gt; Select Through</source>
        <translation>il n’y a là ni nœud ni arête où rattacher (%1)&#xa0;: ce que des points ou du bois cachent ne se clique pas&#xa0;; tournez la plante, ou choisissez Sélection &gt; Sélectionner à travers</translation>
    </message>
    <message>
        <source>Enter: attach %1 to %2   Arrow keys: to another   Click the new parent   Esc: leave it</source>
        <translation>Entrée&#xa0;: rattacher %1 à %2   Flèches&#xa0;: à un autre   Cliquer le nouveau parent   Échap&#xa0;: laisser</translation>
    </message>
    <message>
        <source>Not there: it grows from %1   Choose a parent elsewhere   Esc: leave it</source>
        <translation>Pas là&#xa0;: cela part de %1   Choisir un parent ailleurs   Échap&#xa0;: laisser</translation>
    </message>
</context>
<context>
    <name>espalier::ReportFlow</name>
    <message>
        <source>Export Report…</source>
        <translation>Exporter le rapport…</translation>
    </message>
    <message>
        <source>Writes how the plant agrees with its reference, with pictures, as HTML or PDF</source>
        <translation>Écrit comment la plante s’accorde avec sa référence, avec des images, en HTML ou en PDF</translation>
    </message>
    <message>
        <source>Export the report</source>
        <translation>Exporter le rapport</translation>
    </message>
    <message>
        <source>Web pages (*.html);;PDF (*.pdf)</source>
        <translation>Pages web (*.html);;PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Measuring for the report</source>
        <translation>Mesures pour le rapport</translation>
    </message>
</context>
<context>
    <name>espalier::ReportMaker</name>
    <message>
        <source>The report is still being written: wait for it, or cancel it</source>
        <translation>Le rapport est encore en cours d’écriture&#xa0;: attendez-le, ou annulez-le</translation>
    </message>
    <message>
        <source>Drawing the pictures of %1…</source>
        <translation>Tracé des images de %1…</translation>
    </message>
    <message>
        <source>%1 was not written: another job began; export it again</source>
        <translation>%1 n’a pas été écrit&#xa0;: une autre tâche a commencé&#xa0;; exportez-le à nouveau</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>Écriture de %1</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 écrit</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>No program opens %1 from here</source>
        <translation>Aucun programme n’ouvre %1 d’ici</translation>
    </message>
</context>
<context>
    <name>espalier::ResampleFlow</name>
    <message>
        <source>Resample to Length…</source>
        <translation>Rééchantillonner à une longueur…</translation>
    </message>
    <message>
        <source>Spaces nodes evenly, by a length of edges that you type</source>
        <translation>Espace les nœuds régulièrement, selon une longueur d’arête que vous saisissez</translation>
    </message>
    <message>
        <source>there is no edge between the ends</source>
        <translation>il n’y a pas d’arête entre les extrémités</translation>
    </message>
    <message>
        <source>Resample to Length</source>
        <translation>Rééchantillonner à une longueur</translation>
    </message>
    <message>
        <source>Length of edges</source>
        <translation>Longueur des arêtes</translation>
    </message>
    <message>
        <source>Length of edges [%1]</source>
        <translation>Longueur des arêtes [%1]</translation>
    </message>
    <message>
        <source>Resample</source>
        <translation>Rééchantillonner</translation>
    </message>
</context>
<context>
    <name>espalier::ReviewFlow</name>
    <message>
        <source>nothing is selected to comment on: put the pointer on a node, or select some</source>
        <translation>rien n’est sélectionné à commenter&#xa0;: placez le pointeur sur un nœud, ou sélectionnez-en</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Révision</translation>
    </message>
    <message>
        <source>Next Stop</source>
        <translation>Arrêt suivant</translation>
    </message>
    <message>
        <source>Walks on: along the trunk, then branch by branch with its twigs, or by expected error</source>
        <translation>Avance&#xa0;: le long du tronc, puis branche par branche avec ses brindilles, ou par erreur attendue</translation>
    </message>
    <message>
        <source>Previous Stop</source>
        <translation>Arrêt précédent</translation>
    </message>
    <message>
        <source>Walks back</source>
        <translation>Recule</translation>
    </message>
    <message>
        <source>Next Not Reviewed</source>
        <translation>Non révisé suivant</translation>
    </message>
    <message>
        <source>Walks on to what is to do or doubtful</source>
        <translation>Avance jusqu’à ce qui est à faire ou douteux</translation>
    </message>
    <message>
        <source>Next Open End</source>
        <translation>Extrémité ouverte suivante</translation>
    </message>
    <message>
        <source>Walks on to an apex that is not reviewed</source>
        <translation>Avance jusqu’à un apex qui n’est pas révisé</translation>
    </message>
    <message>
        <source>Next Branching</source>
        <translation>Ramification suivante</translation>
    </message>
    <message>
        <source>Walks on to a branching that is not reviewed</source>
        <translation>Avance jusqu’à une ramification qui n’est pas révisée</translation>
    </message>
    <message>
        <source>Riskiest First</source>
        <translation>Le plus risqué d’abord</translation>
    </message>
    <message>
        <source>Walks by expected error, most first, in place of along the plant</source>
        <translation>Parcourt par erreur attendue, la plus grande d’abord, au lieu de suivre la plante</translation>
    </message>
    <message>
        <source>Mark Reviewed and Go On</source>
        <translation>Marquer révisé et continuer</translation>
    </message>
    <message>
        <source>What is selected and seen is right; shows the next stop that is to do. While nothing is selected, or the panel is not in front, it marks nothing and only shows that stop</source>
        <translation>Ce qui est sélectionné et vu est juste&#xa0;; montre l’arrêt suivant qui est à faire. Tant que rien n’est sélectionné, ou que le panneau n’est pas devant, ne marque rien et ne fait que montrer cet arrêt</translation>
    </message>
    <message>
        <source>Mark Doubtful</source>
        <translation>Marquer douteux</translation>
    </message>
    <message>
        <source>What is selected needs another look; with the panel in front, shows the next stop that is to do</source>
        <translation>Ce qui est sélectionné demande un autre examen&#xa0;; avec le panneau devant, montre l’arrêt suivant qui est à faire</translation>
    </message>
    <message>
        <source>Mark To Do</source>
        <translation>Marquer à faire</translation>
    </message>
    <message>
        <source>What is selected is to be reviewed again</source>
        <translation>Ce qui est sélectionné est à réviser à nouveau</translation>
    </message>
    <message>
        <source>Mark All Selected Reviewed</source>
        <translation>Marquer révisée toute la sélection</translation>
    </message>
    <message>
        <source>Marks all nodes selected that are to do, seen or not; doubtful ones stay so</source>
        <translation>Marque tous les nœuds sélectionnés qui sont à faire, vus ou non&#xa0;; les douteux le restent</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Commentaire</translation>
    </message>
    <message>
        <source>A remark on what is selected, else on the node under the pointer</source>
        <translation>Une remarque sur ce qui est sélectionné, sinon sur le nœud sous le pointeur</translation>
    </message>
    <message>
        <source>Review Panel</source>
        <translation>Panneau de révision</translation>
    </message>
    <message>
        <source>Shows or hides this panel</source>
        <translation>Affiche ou masque ce panneau</translation>
    </message>
    <message>
        <source>Nothing is marked yet, as %1: now it is shown, and {mark_reviewed} marks it</source>
        <translation>Rien n’est encore marqué, car %1&#xa0;: maintenant c’est montré, et {mark_reviewed} le marque</translation>
    </message>
    <message>
        <source>nothing that is selected is to do: it is reviewed or doubtful already</source>
        <translation>rien de ce qui est sélectionné n’est à faire&#xa0;: tout est déjà révisé ou douteux</translation>
    </message>
    <message>
        <source>%1 is doubtful</source>
        <translation>%1 est douteux</translation>
    </message>
    <message>
        <source>%1 are doubtful</source>
        <translation>%1 sont douteux</translation>
    </message>
    <message>
        <source>: %1 once more takes that back and marks it reviewed</source>
        <translation>&#xa0;: %1 encore une fois retire cela et le marque révisé</translation>
    </message>
    <message>
        <source>Mark %1 reviewed</source>
        <translation>Marquer révisé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Mark %1 doubtful</source>
        <translation>Marquer douteux&#xa0;: %1</translation>
    </message>
    <message>
        <source>Mark %1 to do</source>
        <translation>Marquer à faire&#xa0;: %1</translation>
    </message>
    <message>
        <source>Comment on %1</source>
        <translation>Commenter&#xa0;: %1</translation>
    </message>
    <message>
        <source>nothing is selected to mark: select nodes, or press {next_stretch} to walk to a stop</source>
        <translation>rien n’est sélectionné à marquer&#xa0;: sélectionnez des nœuds, ou appuyez sur {next_stretch} pour aller à un arrêt</translation>
    </message>
    <message>
        <source>Press . to walk</source>
        <translation>Parcourir&#xa0;: touche .</translation>
    </message>
    <message>
        <source>Mark All %1 Selected Reviewed</source>
        <translation>Marquer révisés les %1 sélectionnés</translation>
    </message>
    <message>
        <source>All is reviewed: the structure can be signed</source>
        <translation>Tout est révisé&#xa0;: la structure peut être signée</translation>
    </message>
    <message>
        <source>Every end is reviewed</source>
        <translation>Toutes les extrémités sont révisées</translation>
    </message>
    <message>
        <source>Every branching is reviewed</source>
        <translation>Toutes les ramifications sont révisées</translation>
    </message>
    <message>
        <source>Looking where errors are likely…</source>
        <translation>Recherche des endroits où les erreurs sont probables…</translation>
    </message>
    <message>
        <source>Without a scan nothing is known of errors: the walk goes along the plant</source>
        <translation>Sans scan, on ne sait rien des erreurs&#xa0;: le parcours suit la plante</translation>
    </message>
    <message>
        <source>No wood is near these points: add some, or press {mark_reviewed} if there is none</source>
        <translation>Aucun bois n’est près de ces points&#xa0;: ajoutez-en, ou appuyez sur {mark_reviewed} s’il n’y en a pas</translation>
    </message>
    <message>
        <source>Nothing is marked, as not all of these points are shown: choose View &gt; Layers &gt; Points   {show_all} shows what is hidden</source>
        <translation>Rien n’est marqué, car ces points ne sont pas tous affichés&#xa0;: choisissez Vue &gt; Calques &gt; Points   {show_all} affiche ce qui est masqué</translation>
    </message>
    <message>
        <source>Nothing is marked yet, as not all of these points were seen: now they are</source>
        <translation>Rien n’est encore marqué, car ces points n’étaient pas tous vus&#xa0;: maintenant ils le sont</translation>
    </message>
    <message>
        <source>%1 nodes are doubtful</source>
        <translation>%1 nœuds sont douteux</translation>
    </message>
    <message>
        <source>1 node is doubtful</source>
        <translation>1 nœud est douteux</translation>
    </message>
    <message>
        <source>points without wood are doubtful</source>
        <translation>des points sans bois sont douteux</translation>
    </message>
    <message>
        <source>Nothing is to do; %1: {next_not_reviewed} walks there</source>
        <translation>Plus rien n’est à faire&#xa0;; %1&#xa0;: {next_not_reviewed} y mène</translation>
    </message>
    <message>
        <source>No stop left</source>
        <translation>Plus aucun arrêt</translation>
    </message>
    <message>
        <source>1 stop left</source>
        <translation>Reste 1 arrêt</translation>
    </message>
    <message>
        <source>%1 stops left</source>
        <translation>Reste %1 arrêts</translation>
    </message>
    <message>
        <source>The riskiest wood of this stop: %1</source>
        <translation>Le bois le plus risqué de cet arrêt&#xa0;: %1</translation>
    </message>
    <message>
        <source>: %1 once more takes that back and marks them reviewed</source>
        <translation>&#xa0;: %1 encore une fois retire cela et les marque révisés</translation>
    </message>
    <message>
        <source>. Here: no wood</source>
        <translation>. Ici&#xa0;: pas de bois</translation>
    </message>
    <message>
        <source>. Here: clean</source>
        <translation>. Ici&#xa0;: net</translation>
    </message>
    <message>
        <source>. Here: risk %1 %</source>
        <translation>. Ici&#xa0;: risque %1&#xa0;%</translation>
    </message>
    <message>
        <source>Take points for no wood</source>
        <translation>Prendre des points pour autre chose que du bois</translation>
    </message>
</context>
<context>
    <name>espalier::ReviewPanel</name>
    <message>
        <source>Review</source>
        <translation>Révision</translation>
    </message>
    <message>
        <source>◂ Previous</source>
        <translation>◂ Précédent</translation>
    </message>
    <message>
        <source>Next ▸</source>
        <translation>Suivant ▸</translation>
    </message>
    <message>
        <source>Open End</source>
        <translation>Extrémité</translation>
    </message>
    <message>
        <source>Branching</source>
        <translation>Ramification</translation>
    </message>
    <message>
        <source>Riskiest First</source>
        <translation>Le plus risqué d’abord</translation>
    </message>
    <message>
        <source>Reviewed, Go On</source>
        <translation>Révisé, continuer</translation>
    </message>
    <message>
        <source>Doubtful</source>
        <translation>Douteux</translation>
    </message>
    <message>
        <source>To Do</source>
        <translation>À faire</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Commentaire</translation>
    </message>
    <message>
        <source>A remark on the selected nodes (K)</source>
        <translation>Une remarque sur les nœuds sélectionnés (K)</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <source>Reviewer</source>
        <translation>Réviseur</translation>
    </message>
    <message>
        <source>Kept with what you review and sign</source>
        <translation>Gardé avec ce que vous révisez et signez</translation>
    </message>
    <message>
        <source>Sign Structure…</source>
        <translation>Signer la structure…</translation>
    </message>
    <message>
        <source>%1 % reviewed</source>
        <translation>%1&#xa0;% révisé</translation>
    </message>
    <message>
        <source>, in part</source>
        <translation>, en partie</translation>
    </message>
    <message>
        <source>Several comments</source>
        <translation>Plusieurs commentaires</translation>
    </message>
    <message>
        <source>Your name</source>
        <translation>Votre nom</translation>
    </message>
</context>
<context>
    <name>espalier::SampleFlow</name>
    <message>
        <source>Sample Plant</source>
        <translation>Plante d’exemple</translation>
    </message>
    <message>
        <source>Opens a simulated scan of a small tree, to try the program on</source>
        <translation>Ouvre un scan simulé d’un petit arbre, pour essayer le programme</translation>
    </message>
    <message>
        <source>%1 cannot be made: choose Open… and a scan of your own</source>
        <translation>%1 ne peut pas être créé&#xa0;: choisissez Ouvrir… et un scan à vous</translation>
    </message>
    <message>
        <source>Growing a sample plant</source>
        <translation>Croissance d’une plante d’exemple</translation>
    </message>
</context>
<context>
    <name>espalier::SavedViews</name>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Save This View…</source>
        <translation>Enregistrer cette vue…</translation>
    </message>
    <message>
        <source>Keeps camera, clipping and what is hidden, under a name</source>
        <translation>Garde la caméra, le découpage et ce qui est masqué, sous un nom</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Vue %1</translation>
    </message>
    <message>
        <source>Save This View</source>
        <translation>Enregistrer cette vue</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Nom&#xa0;:</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
</context>
<context>
    <name>espalier::ScanDialog</name>
    <message>
        <source>Read files that begin alike so, too</source>
        <translation>Lire aussi ainsi les fichiers qui commencent de même</translation>
    </message>
    <message>
        <source>Open a Scan</source>
        <translation>Ouvrir un scan</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>The unit of the coordinates. They are shown with it, never rescaled.</source>
        <translation>L’unité des coordonnées. Elles sont affichées avec elle, jamais mises à l’échelle.</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>The axis of the file that points up, from the foot of the plant to its top</source>
        <translation>L’axe du fichier qui pointe vers le haut, du pied de la plante à son sommet</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Colonnes</translation>
    </message>
    <message>
        <source>Bounds</source>
        <translation>Limites</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Lire</translation>
    </message>
    <message>
        <source>What the columns hold, above the first lines of the file</source>
        <translation>Ce que contiennent les colonnes, au-dessus des premières lignes du fichier</translation>
    </message>
    <message>
        <source>Columns as they are named here are taken for such files without asking, also after the program is closed</source>
        <translation>Les colonnes telles qu’elles sont nommées ici sont reprises pour de tels fichiers sans demander, même après la fermeture du programme</translation>
    </message>
    <message>
        <source>Points of a scan that are read without asking, at most</source>
        <translation>Points d’un scan qui sont lus sans demander, au plus</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
</context>
<context>
    <name>espalier::ScanDistances</name>
    <message>
        <source>Distances to the scan</source>
        <translation>Distances au scan</translation>
    </message>
</context>
<context>
    <name>espalier::ScanForm</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur&#xa0;%2</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>The unit of the coordinates. They are shown with it, never rescaled.</source>
        <translation>L’unité des coordonnées. Elles sont affichées avec elle, jamais mises à l’échelle.</translation>
    </message>
    <message>
        <source>The axis of the file that points up, from the foot of the plant to its top</source>
        <translation>L’axe du fichier qui pointe vers le haut, du pied de la plante à son sommet</translation>
    </message>
    <message>
        <source>lowest point</source>
        <translation>point le plus bas</translation>
    </message>
    <message>
        <source>pick in the view…</source>
        <translation>choisir dans la vue…</translation>
    </message>
    <message>
        <source>Where the plant begins: the foot of its trunk</source>
        <translation>Où commence la plante&#xa0;: le pied de son tronc</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Root</source>
        <translation>Racine</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>en %1</translation>
    </message>
</context>
<context>
    <name>espalier::SealFlow</name>
    <message>
        <source>Review</source>
        <translation>Révision</translation>
    </message>
    <message>
        <source>Sign Structure…</source>
        <translation>Signer la structure…</translation>
    </message>
    <message>
        <source>Seals the structure once all of it is reviewed</source>
        <translation>Scelle la structure une fois qu’elle est entièrement révisée</translation>
    </message>
    <message>
        <source>Export Seal…</source>
        <translation>Exporter le sceau…</translation>
    </message>
    <message>
        <source>Writes who signed, when, and after what work, as JSON</source>
        <translation>Écrit qui a signé, quand et après quel travail, en JSON</translation>
    </message>
    <message>
        <source>Export Certificate…</source>
        <translation>Exporter le certificat…</translation>
    </message>
    <message>
        <source>Writes one page on the signed structure, with pictures: who signed, what was open, how it agrees with others</source>
        <translation>Écrit une page sur la structure signée, avec des images&#xa0;: qui a signé, ce qui restait ouvert, comment elle s’accorde avec d’autres</translation>
    </message>
    <message>
        <source>Not signed yet.</source>
        <translation>Pas encore signée.</translation>
    </message>
    <message>
        <source>✗ Undone to before it was signed by %1: redo leads back to the seal.</source>
        <translation>✗ Annulé jusqu’avant la signature par %1&#xa0;: rétablir ramène au sceau.</translation>
    </message>
    <message>
        <source>✗ Seal broken: edited since it was signed by %1.</source>
        <translation>✗ Sceau rompu&#xa0;: modifié depuis la signature par %1.</translation>
    </message>
    <message>
        <source>✓ Signed by %1.
At work: %2.
Corrections: %3.</source>
        <translation>✓ Signé par %1.
Travail&#xa0;: %2.
Corrections&#xa0;: %3.</translation>
    </message>
    <message>
        <source>
Findings: %1.</source>
        <translation>
Constats&#xa0;: %1.</translation>
    </message>
    <message>
        <source>
Marked in bulk: %1 of %2 nodes.</source>
        <translation>
Marqués en bloc&#xa0;: %1 nœuds sur %2.</translation>
    </message>
    <message>
        <source>Looking at what is signed</source>
        <translation>Examen de ce qui est signé</translation>
    </message>
    <message>
        <source>the structure was edited meanwhile: sign it again</source>
        <translation>la structure a été modifiée entre-temps&#xa0;: signez-la à nouveau</translation>
    </message>
    <message>
        <source>Signed by %1</source>
        <translation>Signé par %1</translation>
    </message>
    <message>
        <source>%1. Only a project keeps the seal</source>
        <translation>%1. Seul un projet garde le sceau</translation>
    </message>
    <message>
        <source>there is no seal yet: sign the structure first</source>
        <translation>il n’y a pas encore de sceau&#xa0;: signez d’abord la structure</translation>
    </message>
    <message>
        <source>the seal does not hold: go back to what was signed, or sign again</source>
        <translation>le sceau ne tient pas&#xa0;: revenez à ce qui a été signé, ou signez à nouveau</translation>
    </message>
    <message>
        <source>Export the seal</source>
        <translation>Exporter le sceau</translation>
    </message>
    <message>
        <source>Seals (*.json)</source>
        <translation>Sceaux (*.json)</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 écrit</translation>
    </message>
    <message>
        <source>Export the certificate</source>
        <translation>Exporter le certificat</translation>
    </message>
    <message>
        <source>PDF (*.pdf);;Web pages (*.html)</source>
        <translation>PDF (*.pdf);;Pages web (*.html)</translation>
    </message>
    <message>
        <source>Looking at the scan for the certificate</source>
        <translation>Examen du scan pour le certificat</translation>
    </message>
    <message>
        <source>The seal of %1 is lost: what was signed can no longer be redone</source>
        <translation>Le sceau de %1 est perdu&#xa0;: ce qui a été signé ne peut plus être rétabli</translation>
    </message>
    <message>
        <source>This goes back to before the seal of %1. An edit from here loses it</source>
        <translation>Ceci revient avant le sceau de %1. Une modification à partir d’ici le perd</translation>
    </message>
    <message>
        <source>This breaks the seal of %1</source>
        <translation>Ceci rompt le sceau de %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>%1 of %2 nodes are not reviewed: {next_not_reviewed} goes to the next</source>
        <translation>%1 nœuds sur %2 ne sont pas révisés&#xa0;: {next_not_reviewed} mène au suivant</translation>
    </message>
    <message>
        <source>%1 of %2 nodes are not reviewed, %3 of them doubtful: {next_not_reviewed} goes to the next</source>
        <translation>%1 nœuds sur %2 ne sont pas révisés, dont %3 douteux&#xa0;: {next_not_reviewed} mène au suivant</translation>
    </message>
    <message>
        <source>Not signed yet. A project keeps the seal, a file does not.</source>
        <translation>Pas encore signée. Un projet garde le sceau, un fichier non.</translation>
    </message>
    <message>
        <source>%1 of %2 nodes are doubtful: {next_not_reviewed} goes to the next</source>
        <translation>%1 nœuds sur %2 sont douteux&#xa0;: {next_not_reviewed} mène au suivant</translation>
    </message>
</context>
<context>
    <name>espalier::SelectPointsTool</name>
    <message>
        <source>As before. Release the button</source>
        <translation>Comme avant. Relâcher le bouton</translation>
    </message>
    <message>
        <source>There are no points to select: open the scan first</source>
        <translation>Il n’y a pas de points à sélectionner&#xa0;: ouvrez d’abord le scan</translation>
    </message>
    <message>
        <source>Release: these points are %1   Esc: leave it</source>
        <translation>Relâcher&#xa0;: ces points sont classés %1   Échap&#xa0;: laisser</translation>
    </message>
    <message>
        <source>Release: select the points painted   Esc: leave it</source>
        <translation>Relâcher&#xa0;: sélectionner les points peints   Échap&#xa0;: laisser</translation>
    </message>
    <message>
        <source>Release: select the points inside   Esc: leave it</source>
        <translation>Relâcher&#xa0;: sélectionner les points à l’intérieur   Échap&#xa0;: laisser</translation>
    </message>
    <message>
        <source>Points become %1   </source>
        <translation>Points classés %1   </translation>
    </message>
    <message>
        <source>   {remove} set aside   {remove_subtree} keep only</source>
        <translation>   {remove} mettre de côté   {remove_subtree} ne garder que ceux-ci</translation>
    </message>
    <message>
        <source>%1   Shift: add   Alt: take away   Ctrl: only turn view   {points_shape} %2</source>
        <translation>%1   Maj&#xa0;: ajouter   Alt&#xa0;: retirer   Ctrl&#xa0;: tourner seulement la vue   {points_shape} %2</translation>
    </message>
    <message>
        <source>Drag: paint points</source>
        <translation>Glisser&#xa0;: peindre des points</translation>
    </message>
    <message>
        <source>box</source>
        <translation>boîte</translation>
    </message>
    <message>
        <source>   {brush_larger} larger   {brush_smaller} smaller</source>
        <translation>   {brush_larger} plus grand   {brush_smaller} plus petit</translation>
    </message>
    <message>
        <source>Drag: box about points</source>
        <translation>Glisser&#xa0;: boîte autour de points</translation>
    </message>
    <message>
        <source>lasso</source>
        <translation>lasso</translation>
    </message>
    <message>
        <source>Drag: lasso about points</source>
        <translation>Glisser&#xa0;: lasso autour de points</translation>
    </message>
    <message>
        <source>brush</source>
        <translation>pinceau</translation>
    </message>
    <message>
        <source>%1   Shift: add   Alt: take away   Drag: turn   {points_shape} brush</source>
        <translation>%1   Maj&#xa0;: ajouter   Alt&#xa0;: retirer   Glisser&#xa0;: tourner   {points_shape} pinceau</translation>
    </message>
</context>
<context>
    <name>espalier::ShortcutSheet</name>
    <message>
        <source>Mouse</source>
        <translation>Souris</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Glisser</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Tourner</translation>
    </message>
    <message>
        <source>Right drag</source>
        <translation>Glisser, bouton droit</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Déplacer la vue</translation>
    </message>
    <message>
        <source>Middle drag, wheel</source>
        <translation>Glisser, bouton du milieu, ou molette</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoomer</translation>
    </message>
    <message>
        <source>Ctrl+drag</source>
        <translation>Ctrl+glisser</translation>
    </message>
    <message>
        <source>Turn, over nodes too</source>
        <translation>Tourner, même sur des nœuds</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Ctrl+molette</translation>
    </message>
    <message>
        <source>Radius of the selected nodes</source>
        <translation>Rayon des nœuds sélectionnés</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Clic</translation>
    </message>
    <message>
        <source>Select a node</source>
        <translation>Sélectionner un nœud</translation>
    </message>
    <message>
        <source>Shift+click</source>
        <translation>Maj+clic</translation>
    </message>
    <message>
        <source>Add or remove a node</source>
        <translation>Ajouter ou retirer un nœud</translation>
    </message>
    <message>
        <source>Shift+drag</source>
        <translation>Maj+glisser</translation>
    </message>
    <message>
        <source>Select in a box</source>
        <translation>Sélectionner dans une boîte</translation>
    </message>
    <message>
        <source>Alt+drag</source>
        <translation>Alt+glisser</translation>
    </message>
    <message>
        <source>Select in a lasso</source>
        <translation>Sélectionner dans un lasso</translation>
    </message>
    <message>
        <source>Drag a node</source>
        <translation>Glisser un nœud</translation>
    </message>
    <message>
        <source>Move it</source>
        <translation>Le déplacer</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Double clic</translation>
    </message>
    <message>
        <source>Turn around this place</source>
        <translation>Tourner autour de cet endroit</translation>
    </message>
    <message>
        <source>Right click</source>
        <translation>Clic droit</translation>
    </message>
    <message>
        <source>Menu of the node</source>
        <translation>Menu du nœud</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Échap</translation>
    </message>
    <message>
        <source>Leave a gesture</source>
        <translation>Quitter un geste</translation>
    </message>
    <message>
        <source>Change…</source>
        <translation>Changer…</translation>
    </message>
    <message>
        <source>%1: %2. Change</source>
        <translation>%1&#xa0;: %2. Changer</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Raccourcis</translation>
    </message>
    <message>
        <source>Change Keys…</source>
        <translation>Changer les touches…</translation>
    </message>
</context>
<context>
    <name>espalier::Shown</name>
    <message>
        <source>Registration</source>
        <translation>Recalage</translation>
    </message>
    <message>
        <source>The plant is moved to where it fits the reference best, from several starts, before anything is measured: two files of one plant are often not in the same frame. It is turned only where that lowers the mean distance by a tenth.</source>
        <translation>La plante est déplacée là où elle s’ajuste le mieux à la référence, à partir de plusieurs départs, avant toute mesure&#xa0;: deux fichiers d’une même plante ne sont souvent pas dans le même repère. Elle n’est tournée que là où cela abaisse la distance moyenne d’un dixième.</translation>
    </message>
    <message>
        <source>Precision, recall, F</source>
        <translation>Précision, rappel, F</translation>
    </message>
    <message>
        <source>Shares of the length of the plant near the reference, and of the reference near the plant, and their harmonic mean; places are sampled at even steps, distances taken to edges.</source>
        <translation>Parts de la longueur de la plante proches de la référence, et de la référence proches de la plante, et leur moyenne harmonique&#xa0;; les endroits sont échantillonnés à pas réguliers, les distances prises aux arêtes.</translation>
    </message>
    <message>
        <source>Missed, invented, wrongly attached</source>
        <translation>Manqué, inventé, mal attaché</translation>
    </message>
    <message>
        <source>Stretches without anything of the other within the tolerance; and what lies right but is attached to wood that meets its own more than four tolerances farther down.</source>
        <translation>Tronçons sans rien de l’autre dans la tolérance&#xa0;; et ce qui est bien placé mais attaché à du bois qui ne rejoint le sien qu’à plus de quatre tolérances plus bas.</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Distances</translation>
    </message>
    <message>
        <source>G, T and mapping</source>
        <translation>G, T et correspondance</translation>
    </message>
    <message>
        <source>Unbranched segments are matched one to one at the least sum of Hausdorff distances; G is the share of length matched, T that of matches that are attached to matches. Both hardly fall with noise.</source>
        <translation>Les segments non ramifiés sont appariés un à un pour la plus petite somme de distances de Hausdorff&#xa0;; G est la part de longueur appariée, T celle des appariements qui sont attachés à des appariements. Les deux ne baissent guère avec le bruit.</translation>
    </message>
    <message>
        <source>Capped, over all, one to many</source>
        <translation>Bornés, sur tout, un à plusieurs</translation>
    </message>
    <message>
        <source>The same with nothing hidden: matches lie within the distance as curves, T counts all segments of the reference, and a branch may match the pieces that spurs cut it into.</source>
        <translation>La même chose sans rien cacher&#xa0;: les appariements sont dans la distance en tant que courbes, T compte tous les segments de la référence, et une branche peut s’apparier aux morceaux en lesquels des rameaux courts la coupent.</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Points remarquables</translation>
    </message>
    <message>
        <source>DIADEM-like score</source>
        <translation>Score de type DIADEM</translation>
    </message>
    <message>
        <source>Share of tips and branchings that are found and reached along a path as long, from the next one below that is found; invented ones count against it.</source>
        <translation>Part des extrémités et ramifications qui sont trouvées et atteintes par un chemin aussi long, depuis la suivante vers le bas qui est trouvée&#xa0;; celles qui sont inventées comptent en moins.</translation>
    </message>
    <message>
        <source>NetMets</source>
        <translation>NetMets</translation>
    </message>
    <message>
        <source>Shares of length that the other plant lacks, by a Gaussian of the distance; and of the paths between tips and branchings that both have, those that only one has.</source>
        <translation>Parts de longueur qui manquent à l’autre plante, par une gaussienne de la distance&#xa0;; et, des chemins entre extrémités et ramifications que les deux ont, ceux qu’une seule a.</translation>
    </message>
    <message>
        <source>Barcodes (TMD)</source>
        <translation>Codes-barres (TMD)</translation>
    </message>
    <message>
        <source>Each tip is a bar, from where it leaves something longer up to its end, along the plant; 0 where all bars are alike, 1 where none is.</source>
        <translation>Chaque extrémité est une barre, de là où elle quitte quelque chose de plus long jusqu’à son bout, le long de la plante&#xa0;; 0 où toutes les barres sont semblables, 1 où aucune ne l’est.</translation>
    </message>
    <message>
        <source>Orders, axes, edges</source>
        <translation>Ordres, axes, arêtes</translation>
    </message>
    <message>
        <source>Kappa</source>
        <translation>Kappa</translation>
    </message>
    <message>
        <source>Agreement on what continues an axis and what branches, at the feet of matched segments, beyond what chance would do.</source>
        <translation>Accord sur ce qui continue un axe et ce qui ramifie, au pied des segments appariés, au-delà de ce que ferait le hasard.</translation>
    </message>
    <message>
        <source>Edit distance</source>
        <translation>Distance d’édition</translation>
    </message>
    <message>
        <source>The least that has to be removed and inserted to make one tree of the other, where what is attached to what must stay; similarity 1 where nothing is to be done.</source>
        <translation>Le moins qu’il faut supprimer et insérer pour faire un arbre de l’autre, où ce qui est attaché à quoi doit rester&#xa0;; similarité 1 où rien n’est à faire.</translation>
    </message>
    <message>
        <source>Radii</source>
        <translation>Rayons</translation>
    </message>
    <message>
        <source>Concordance</source>
        <translation>Concordance</translation>
    </message>
    <message>
        <source>Agreement of radii where both plants lie near each other: 1 where all are the same. Unlike a correlation it falls where all are too large alike.</source>
        <translation>Accord des rayons là où les deux plantes sont proches l’une de l’autre&#xa0;: 1 où tous sont identiques. Contrairement à une corrélation, elle baisse quand tous sont trop grands de la même façon.</translation>
    </message>
    <message>
        <source>Breast height, and the circumference</source>
        <translation>Hauteur de poitrine, et la circonférence</translation>
    </message>
    <message>
        <source>Stems are measured 1.3 m above the foot of the reference. Of 16 sectors about a node of the reference, those that hold points of its section are the share of the circumference the scanner saw.</source>
        <translation>Les tiges sont mesurées à 1.3 m au-dessus du pied de la référence. Sur 16 secteurs autour d’un nœud de la référence, ceux qui contiennent des points de sa section sont la part de la circonférence que le scanner a vue.</translation>
    </message>
    <message>
        <source>Root mean square error of radii where the scan has points on this much of the circumference of the wood</source>
        <translation>Racine de l’erreur quadratique moyenne des rayons là où le scan a des points sur cette part de la circonférence du bois</translation>
    </message>
    <message>
        <source>concordance (CCC)</source>
        <translation>concordance (CCC)</translation>
    </message>
    <message>
        <source>concordance</source>
        <translation>concordance</translation>
    </message>
    <message>
        <source>Agreement of radii where both lie near each other: 1 where all are the same (CCC, Lin)</source>
        <translation>Accord des rayons là où les deux sont proches&#xa0;: 1 où tous sont identiques (CCC, Lin)</translation>
    </message>
    <message>
        <source>mean error</source>
        <translation>erreur moyenne</translation>
    </message>
    <message>
        <source>radius, mean error</source>
        <translation>rayon, erreur moyenne</translation>
    </message>
    <message>
        <source>Of the radii: above 0, the plant&apos;s are larger</source>
        <translation>Des rayons&#xa0;: au-dessus de 0, ceux de la plante sont plus grands</translation>
    </message>
    <message>
        <source>root mean square error</source>
        <translation>racine de l’erreur quadratique moyenne</translation>
    </message>
    <message>
        <source>radius, RMS error</source>
        <translation>rayon, erreur RMS</translation>
    </message>
    <message>
        <source>Root mean square error of the radii, over the length where both lie near each other</source>
        <translation>Racine de l’erreur quadratique moyenne des rayons, sur la longueur où les deux sont proches</translation>
    </message>
    <message>
        <source>diameter at 1.3 m</source>
        <translation>diamètre à 1.3 m</translation>
    </message>
    <message>
        <source>Of the plant&apos;s stem, 1.3 m above the foot of the reference (DBH)</source>
        <translation>De la tige de la plante, à 1.3 m au-dessus du pied de la référence (DHP)</translation>
    </message>
    <message>
        <source>error of the diameter</source>
        <translation>erreur du diamètre</translation>
    </message>
    <message>
        <source>diameter, error</source>
        <translation>diamètre, erreur</translation>
    </message>
    <message>
        <source>The diameter of the plant at 1.3 m less that of the reference</source>
        <translation>Le diamètre de la plante à 1.3 m moins celui de la référence</translation>
    </message>
    <message>
        <source>shift</source>
        <translation>translation</translation>
    </message>
    <message>
        <source>How far apart both were before they were aligned</source>
        <translation>De combien les deux étaient écartées avant d’être recalées</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>rotation</translation>
    </message>
    <message>
        <source>turn, °</source>
        <translation>rotation, °</translation>
    </message>
    <message>
        <source>By how many degrees the plant was turned to lie on the reference</source>
        <translation>De combien de degrés la plante a été tournée pour se poser sur la référence</translation>
    </message>
    <message>
        <source>nodes</source>
        <translation>nœuds</translation>
    </message>
    <message>
        <source>Nodes it has</source>
        <translation>Nombre de ses nœuds</translation>
    </message>
    <message>
        <source>mapping</source>
        <translation>correspondance</translation>
    </message>
    <message>
        <source>Share of the segments of both that are matched (authors)</source>
        <translation>Part des segments des deux qui sont appariés (auteurs)</translation>
    </message>
    <message>
        <source>geometric index G</source>
        <translation>indice géométrique G</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>Share of the length of both that is matched (authors)</source>
        <translation>Part de la longueur des deux qui est appariée (auteurs)</translation>
    </message>
    <message>
        <source>structural index T</source>
        <translation>indice structurel T</translation>
    </message>
    <message>
        <source>T</source>
        <translation>T</translation>
    </message>
    <message>
        <source>Share of the matches whose nearest matched segments below are matched to each other (authors)</source>
        <translation>Part des appariements dont les segments appariés les plus proches vers le bas sont appariés l’un à l’autre (auteurs)</translation>
    </message>
    <message>
        <source>T over all segments of the reference</source>
        <translation>T sur tous les segments de la référence</translation>
    </message>
    <message>
        <source>T of all</source>
        <translation>T sur tout</translation>
    </message>
    <message>
        <source>The same as a share of all segments of the reference</source>
        <translation>La même chose, comme part de tous les segments de la référence</translation>
    </message>
    <message>
        <source>G, one to many</source>
        <translation>G, un à plusieurs</translation>
    </message>
    <message>
        <source>The same as G, where a branch may match all the pieces that spurs cut it into</source>
        <translation>Comme G, mais une branche peut s’apparier à tous les morceaux en lesquels des rameaux courts la coupent</translation>
    </message>
    <message>
        <source>capped G</source>
        <translation>G borné</translation>
    </message>
    <message>
        <source>The same as G, matched only where they lie within the tolerance</source>
        <translation>Comme G, apparié seulement là où ils sont dans la tolérance</translation>
    </message>
    <message>
        <source>capped T</source>
        <translation>T borné</translation>
    </message>
    <message>
        <source>The same as T of all, matched only where they lie within the tolerance</source>
        <translation>Comme T sur tout, apparié seulement là où ils sont dans la tolérance</translation>
    </message>
    <message>
        <source>precision</source>
        <translation>précision</translation>
    </message>
    <message>
        <source>Share of the plant&apos;s length near the reference</source>
        <translation>Part de la longueur de la plante proche de la référence</translation>
    </message>
    <message>
        <source>recall</source>
        <translation>rappel</translation>
    </message>
    <message>
        <source>Share of the reference&apos;s length near the plant</source>
        <translation>Part de la longueur de la référence proche de la plante</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>Harmonic mean of precision and recall</source>
        <translation>Moyenne harmonique de la précision et du rappel</translation>
    </message>
    <message>
        <source>to the reference</source>
        <translation>vers la référence</translation>
    </message>
    <message>
        <source>Mean distance from the plant to the reference</source>
        <translation>Distance moyenne de la plante à la référence</translation>
    </message>
    <message>
        <source>from the reference</source>
        <translation>depuis la référence</translation>
    </message>
    <message>
        <source>Mean distance from the reference to the plant</source>
        <translation>Distance moyenne de la référence à la plante</translation>
    </message>
    <message>
        <source>far, of the plant</source>
        <translation>éloigné, de la plante</translation>
    </message>
    <message>
        <source>Share of the plant&apos;s length that is farther from the reference than the finest tolerance</source>
        <translation>Part de la longueur de la plante qui est plus éloignée de la référence que la tolérance la plus fine</translation>
    </message>
    <message>
        <source>substantial distance</source>
        <translation>distance notable</translation>
    </message>
    <message>
        <source>Mean distance of that length from the reference</source>
        <translation>Distance moyenne de cette longueur à la référence</translation>
    </message>
    <message>
        <source>far, of the reference</source>
        <translation>éloigné, de la référence</translation>
    </message>
    <message>
        <source>Share of the reference&apos;s length that is farther from the plant than the finest tolerance</source>
        <translation>Part de la longueur de la référence qui est plus éloignée de la plante que la tolérance la plus fine</translation>
    </message>
    <message>
        <source>substantial, back</source>
        <translation>distance notable, retour</translation>
    </message>
    <message>
        <source>Mean distance of that length from the plant</source>
        <translation>Distance moyenne de cette longueur à la plante</translation>
    </message>
    <message>
        <source>tips, F</source>
        <translation>extrémités, F</translation>
    </message>
    <message>
        <source>Ends that lie within a median edge of each other</source>
        <translation>Extrémités qui sont à moins d’une arête médiane l’une de l’autre</translation>
    </message>
    <message>
        <source>branchings, F</source>
        <translation>ramifications, F</translation>
    </message>
    <message>
        <source>Branchings that lie within a median edge of each other</source>
        <translation>Ramifications qui sont à moins d’une arête médiane l’une de l’autre</translation>
    </message>
    <message>
        <source>DIADEM</source>
        <translation>DIADEM</translation>
    </message>
    <message>
        <source>Share of tips and branchings that are found and reached along a path as long</source>
        <translation>Part des extrémités et ramifications qui sont trouvées et atteintes par un chemin aussi long</translation>
    </message>
    <message>
        <source>paths along the plant as long, up to a tenth</source>
        <translation>chemins le long de la plante aussi longs, à un dixième près</translation>
    </message>
    <message>
        <source>paths</source>
        <translation>chemins</translation>
    </message>
    <message>
        <source>Share of pairs of places whose path along the plant is as long, up to a tenth</source>
        <translation>Part des paires d’endroits dont le chemin le long de la plante est aussi long, à un dixième près</translation>
    </message>
    <message>
        <source>length of the same order</source>
        <translation>longueur du même ordre</translation>
    </message>
    <message>
        <source>same order</source>
        <translation>même ordre</translation>
    </message>
    <message>
        <source>Share of the reference&apos;s length near the plant that has the same order there</source>
        <translation>Part de la longueur de la référence proche de la plante qui y a le même ordre</translation>
    </message>
    <message>
        <source>length on the same axis</source>
        <translation>longueur sur le même axe</translation>
    </message>
    <message>
        <source>same axis</source>
        <translation>même axe</translation>
    </message>
    <message>
        <source>Share of the reference&apos;s length near the plant that lies on the same axis there</source>
        <translation>Part de la longueur de la référence proche de la plante qui y est sur le même axe</translation>
    </message>
    <message>
        <source>edge types, share that agrees</source>
        <translation>types d’arête, part en accord</translation>
    </message>
    <message>
        <source>same edge type</source>
        <translation>même type d’arête</translation>
    </message>
    <message>
        <source>Share of matched segments that begin with the same type of edge</source>
        <translation>Part des segments appariés qui commencent par le même type d’arête</translation>
    </message>
    <message>
        <source>edge types, kappa</source>
        <translation>types d’arête, kappa</translation>
    </message>
    <message>
        <source>edge types, κ</source>
        <translation>types d’arête, κ</translation>
    </message>
    <message>
        <source>Agreement on what continues an axis and what branches, beyond chance (Cohen)</source>
        <translation>Accord sur ce qui continue un axe et ce qui ramifie, au-delà du hasard (Cohen)</translation>
    </message>
    <message>
        <source>wrong attachments</source>
        <translation>mauvais points d’attache</translation>
    </message>
    <message>
        <source>Parts of the plant that are attached to something else in the reference</source>
        <translation>Parties de la plante qui sont attachées à autre chose dans la référence</translation>
    </message>
    <message>
        <source>NetMets, length missed</source>
        <translation>NetMets, longueur manquée</translation>
    </message>
    <message>
        <source>length missed</source>
        <translation>longueur manquée</translation>
    </message>
    <message>
        <source>Share of the reference&apos;s length that the plant lacks, by a Gaussian of the distance (NetMets)</source>
        <translation>Part de la longueur de la référence qui manque à la plante, par une gaussienne de la distance (NetMets)</translation>
    </message>
    <message>
        <source>NetMets, length invented</source>
        <translation>NetMets, longueur inventée</translation>
    </message>
    <message>
        <source>length invented</source>
        <translation>longueur inventée</translation>
    </message>
    <message>
        <source>Share of the plant&apos;s length that the reference lacks, by a Gaussian of the distance (NetMets)</source>
        <translation>Part de la longueur de la plante qui manque à la référence, par une gaussienne de la distance (NetMets)</translation>
    </message>
    <message>
        <source>NetMets, connections missed</source>
        <translation>NetMets, liens manqués</translation>
    </message>
    <message>
        <source>connections missed</source>
        <translation>liens manqués</translation>
    </message>
    <message>
        <source>Of the paths between tips and branchings that both have, the share of the reference&apos;s that the plant lacks (NetMets)</source>
        <translation>Des chemins entre extrémités et ramifications que les deux ont, la part de ceux de la référence qui manquent à la plante (NetMets)</translation>
    </message>
    <message>
        <source>NetMets, connections invented</source>
        <translation>NetMets, liens inventés</translation>
    </message>
    <message>
        <source>connections invented</source>
        <translation>liens inventés</translation>
    </message>
    <message>
        <source>Of the paths between tips and branchings that both have, the share of the plant&apos;s that the reference lacks (NetMets)</source>
        <translation>Des chemins entre extrémités et ramifications que les deux ont, la part de ceux de la plante qui manquent à la référence (NetMets)</translation>
    </message>
    <message>
        <source>distance of the barcodes (TMD)</source>
        <translation>distance des codes-barres (TMD)</translation>
    </message>
    <message>
        <source>barcodes apart</source>
        <translation>écart des codes-barres</translation>
    </message>
    <message>
        <source>How far the two differ in where along them their branches begin and end: 0 not at all, 1 wholly (TMD)</source>
        <translation>De combien les deux diffèrent par les endroits où leurs branches commencent et finissent le long d’elles&#xa0;: 0 pas du tout, 1 entièrement (TMD)</translation>
    </message>
    <message>
        <source>edit distance</source>
        <translation>distance d’édition</translation>
    </message>
    <message>
        <source>The least that has to be removed, inserted and changed to make one of the other, in parts: for the costs topology and attributes</source>
        <translation>Le moins qu’il faut supprimer, insérer et changer pour faire l’une de l’autre, en parties&#xa0;: pour les coûts topologie et attributs</translation>
    </message>
    <message>
        <source>edits, in length</source>
        <translation>éditions, en longueur</translation>
    </message>
    <message>
        <source>The least that has to be removed, inserted and changed to make one of the other: for the costs length, place and shape</source>
        <translation>Le moins qu’il faut supprimer, insérer et changer pour faire l’une de l’autre&#xa0;: pour les coûts longueur, place et forme</translation>
    </message>
    <message>
        <source>edit similarity</source>
        <translation>similarité d’édition</translation>
    </message>
    <message>
        <source>edits, similarity</source>
        <translation>éditions, similarité</translation>
    </message>
    <message>
        <source>1 where nothing is to be edited, 0 where nothing of the plant is of use</source>
        <translation>1 où rien n’est à éditer, 0 où rien de la plante ne sert</translation>
    </message>
    <message>
        <source>edits: removed</source>
        <translation>éditions&#xa0;: supprimé</translation>
    </message>
    <message>
        <source>to remove</source>
        <translation>à supprimer</translation>
    </message>
    <message>
        <source>Parts of the plant that stand for nothing of the reference</source>
        <translation>Parties de la plante qui ne correspondent à rien de la référence</translation>
    </message>
    <message>
        <source>edits: inserted</source>
        <translation>éditions&#xa0;: inséré</translation>
    </message>
    <message>
        <source>to insert</source>
        <translation>à insérer</translation>
    </message>
    <message>
        <source>Parts of the reference that nothing of the plant stands for</source>
        <translation>Parties de la référence auxquelles rien de la plante ne correspond</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>Sensibilité</translation>
    </message>
    <message>
        <source>At 2, all limits below are half as high: more is reported. It sets how near explained points are, too.</source>
        <translation>À 2, toutes les limites ci-dessous sont deux fois plus basses&#xa0;: plus de choses sont signalées. Règle aussi à quelle distance sont les points expliqués.</translation>
    </message>
    <message>
        <source>Sharp turn</source>
        <translation>Virage brusque</translation>
    </message>
    <message>
        <source>An axis that turns by more at a node is reported.</source>
        <translation>Un axe qui tourne davantage à un nœud est signalé.</translation>
    </message>
    <message>
        <source>Branch turning back</source>
        <translation>Branche qui revient en arrière</translation>
    </message>
    <message>
        <source>A branch that turns by more from what bears it, or from its first edge, is reported.</source>
        <translation>Une branche qui tourne davantage par rapport à ce qui la porte, ou à sa première arête, est signalée.</translation>
    </message>
    <message>
        <source>Short edge</source>
        <translation>Arête courte</translation>
    </message>
    <message>
        <source>Edges shorter than this share of the mean edge have no length.</source>
        <translation>Les arêtes plus courtes que cette part de l’arête moyenne n’ont pas de longueur.</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Doublon</translation>
    </message>
    <message>
        <source>Edges whose ends lie within this share of their length are duplicates.</source>
        <translation>Les arêtes dont les extrémités sont à moins de cette part de leur longueur sont des doublons.</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Contact</translation>
    </message>
    <message>
        <source>Center lines within so many point spacings touch, however thin the wood.</source>
        <translation>Des lignes centrales à moins de ce nombre d’espacements se touchent, si mince que soit le bois.</translation>
    </message>
    <message>
        <source>Detour</source>
        <translation>Détour</translation>
    </message>
    <message>
        <source>Thicker than parent</source>
        <translation>Plus épais que le parent</translation>
    </message>
    <message>
        <source>Nodes thicker than their parent by this share are reported.</source>
        <translation>Les nœuds plus épais que leur parent de cette part sont signalés.</translation>
    </message>
    <message>
        <source>Reach of edges</source>
        <translation>Portée des arêtes</translation>
    </message>
    <message>
        <source>Points farther from the wood, in point spacings, or more where these scatter or the wood lies off them, are unexplained.</source>
        <translation>Les points plus loin du bois, en espacements, ou davantage là où ils sont dispersés ou que le bois s’en écarte, sont inexpliqués.</translation>
    </message>
    <message>
        <source>Cluster gap</source>
        <translation>Lacune d’un amas</translation>
    </message>
    <message>
        <source>Unexplained points within so many point spacings are one cluster.</source>
        <translation>Les points inexpliqués à moins de ce nombre d’espacements forment un amas.</translation>
    </message>
    <message>
        <source>Cluster size</source>
        <translation>Taille d’un amas</translation>
    </message>
    <message>
        <source>Clusters of fewer points are strays of the scanner.</source>
        <translation>Les amas de moins de points sont des points isolés du scanner.</translation>
    </message>
    <message>
        <source>Cluster stands out</source>
        <translation>Saillie d’un amas</translation>
    </message>
    <message>
        <source>The farthest point of a small cluster is so many times as far off as the reach of edges.</source>
        <translation>Le point le plus éloigné d’un petit amas est ce nombre de fois plus loin que la portée des arêtes.</translation>
    </message>
    <message>
        <source>Large cluster</source>
        <translation>Grand amas</translation>
    </message>
    <message>
        <source>Clusters of so many points need not stand out.</source>
        <translation>Les amas d’autant de points n’ont pas besoin d’être saillants.</translation>
    </message>
    <message>
        <source>Reach of points</source>
        <translation>Portée des points</translation>
    </message>
    <message>
        <source>Edges with no points within so many point spacings, along over a half, are reported.</source>
        <translation>Les arêtes sans points à moins de ce nombre d’espacements, sur plus de la moitié, sont signalées.</translation>
    </message>
    <message>
        <source>Reach of other wood</source>
        <translation>Portée d’un autre bois</translation>
    </message>
    <message>
        <source>Points within so many point spacings of other wood are not a branch&apos;s own.</source>
        <translation>Les points à moins de ce nombre d’espacements d’un autre bois ne sont pas propres à une branche.</translation>
    </message>
    <message>
        <source>Reach of own points</source>
        <translation>Portée des points propres</translation>
    </message>
    <message>
        <source>Own points of a branch lie within so many point spacings of it.</source>
        <translation>Les points propres d’une branche sont à moins de ce nombre d’espacements d’elle.</translation>
    </message>
    <message>
        <source>Own points</source>
        <translation>Points propres</translation>
    </message>
    <message>
        <source>Fewer own points at a place of a branch are strays.</source>
        <translation>Moins de points propres à un endroit d’une branche sont des points isolés.</translation>
    </message>
    <message>
        <source>Length without own points</source>
        <translation>Longueur sans points propres</translation>
    </message>
    <message>
        <source>Branches that begin with more point spacings without own points are reported.</source>
        <translation>Les branches qui commencent par une plus grande longueur sans points propres, en espacements, sont signalées.</translation>
    </message>
    <message>
        <source>Points expected</source>
        <translation>Points attendus</translation>
    </message>
    <message>
        <source>A stretch without points is reported if wood as thick has more points than this elsewhere.</source>
        <translation>Un tronçon sans points est signalé si du bois aussi épais a ailleurs plus de points que cela.</translation>
    </message>
    <message>
        <source>Turn of hidden wood</source>
        <translation>Virage du bois caché</translation>
    </message>
    <message>
        <source>Wood without points that goes on from wood with points and turns by less was hidden from the scanner.</source>
        <translation>Le bois sans points qui prolonge du bois avec points et tourne moins était caché au scanner.</translation>
    </message>
    <message>
        <source>Beside its points</source>
        <translation>À côté de ses points</translation>
    </message>
    <message>
        <source>Wood that lies farther beside its points, in point spacings, or more where these scatter, is reported.</source>
        <translation>Le bois qui est plus loin à côté de ses points, en espacements, ou davantage là où ils sont dispersés, est signalé.</translation>
    </message>
    <message>
        <source>Beside its points, in radii</source>
        <translation>À côté de ses points, en rayons</translation>
    </message>
    <message>
        <source>Likewise, in radii of the wood; both must be exceeded.</source>
        <translation>De même, en rayons du bois&#xa0;; les deux doivent être dépassés.</translation>
    </message>
    <message>
        <source>Short foot</source>
        <translation>Pied trop court</translation>
    </message>
    <message>
        <source>Points of a stem that go on farther below its root, in point spacings, are reported.</source>
        <translation>Les points d’une tige qui se prolongent davantage sous sa racine, en espacements, sont signalés.</translation>
    </message>
    <message>
        <source>Short foot, in radii</source>
        <translation>Pied court, en rayons</translation>
    </message>
    <message>
        <source>Likewise, in radii of the stem; both must be exceeded.</source>
        <translation>De même, en rayons de la tige&#xa0;; les deux doivent être dépassés.</translation>
    </message>
    <message>
        <source>Neighbors</source>
        <translation>Voisins</translation>
    </message>
    <message>
        <source>How many of the nearest points are looked at.</source>
        <translation>Combien de points les plus proches sont examinés.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>A point is left out if its neighbors are farther away than this in the mean.</source>
        <translation>Un point est écarté si ses voisins sont en moyenne plus loin que cela.</translation>
    </message>
    <message>
        <source>Leave out isolated points</source>
        <translation>Écarter les points isolés</translation>
    </message>
    <message>
        <source>Leaves out points that stand alone, as dust and split laser beams do, and the few that lie far from the plant.</source>
        <translation>Écarte les points qui sont seuls, comme en donnent la poussière et les faisceaux laser partagés, et les quelques-uns loin de la plante.</translation>
    </message>
    <message>
        <source>Deviations</source>
        <translation>Écarts-types</translation>
    </message>
    <message>
        <source>A point is left out if its neighbors are farther away in the mean than those of others, by so many standard deviations.</source>
        <translation>Un point est écarté si ses voisins sont en moyenne plus loin que ceux des autres, de ce nombre d’écarts-types.</translation>
    </message>
    <message>
        <source>Leave out statistical outliers</source>
        <translation>Écarter les valeurs aberrantes</translation>
    </message>
    <message>
        <source>Leaves out points whose neighbors are farther away than those of most points.</source>
        <translation>Écarte les points dont les voisins sont plus loin que ceux de la plupart des points.</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Part</translation>
    </message>
    <message>
        <source>Share of the points that is left out, those that lie thinnest.</source>
        <translation>Part des points qui est écartée, ceux qui sont les plus clairsemés.</translation>
    </message>
    <message>
        <source>Leave out the thinnest points</source>
        <translation>Écarter les points les plus clairsemés</translation>
    </message>
    <message>
        <source>Leaves out the share of the points that lie thinnest, by the distance to their neighbors.</source>
        <translation>Écarte la part des points qui sont les plus clairsemés, par la distance à leurs voisins.</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Garder</translation>
    </message>
    <message>
        <source>Which parts stay. The rooted one is that nearest to the root that was chosen; without one, the largest.</source>
        <translation>Quelles parties restent. Celle de la racine est la plus proche de la racine choisie&#xa0;; sans racine choisie, la plus grande.</translation>
    </message>
    <message>
        <source>The largest</source>
        <translation>La plus grande</translation>
    </message>
    <message>
        <source>The rooted one</source>
        <translation>Celle de la racine</translation>
    </message>
    <message>
        <source>All large ones</source>
        <translation>Toutes les grandes</translation>
    </message>
    <message>
        <source>Widest gap</source>
        <translation>Lacune maximale</translation>
    </message>
    <message>
        <source>Points farther apart than this are of different parts.</source>
        <translation>Les points plus éloignés entre eux que cela sont de parties différentes.</translation>
    </message>
    <message>
        <source>Least points</source>
        <translation>Minimum de points</translation>
    </message>
    <message>
        <source>Parts of fewer points are left out, where all large ones stay.</source>
        <translation>Les parties de moins de points sont écartées, quand toutes les grandes restent.</translation>
    </message>
    <message>
        <source>Leave out loose parts</source>
        <translation>Écarter les parties détachées</translation>
    </message>
    <message>
        <source>Keeps the parts that are large, or one of them, and leaves out what is not connected with it.</source>
        <translation>Garde les parties qui sont grandes, ou l’une d’elles, et écarte ce qui n’y est pas relié.</translation>
    </message>
    <message>
        <source>Keeps all points.</source>
        <translation>Garde tous les points.</translation>
    </message>
    <message>
        <source>Least step</source>
        <translation>Pas minimal</translation>
    </message>
    <message>
        <source>Distance between nodes where points are sparsest, as in twigs.</source>
        <translation>Distance entre les nœuds là où les points sont les plus clairsemés, comme dans les brindilles.</translation>
    </message>
    <message>
        <source>Greatest step</source>
        <translation>Pas maximal</translation>
    </message>
    <message>
        <source>Distance between nodes where points are densest, as in thick wood.</source>
        <translation>Distance entre les nœuds là où les points sont les plus denses, comme dans le bois épais.</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Portée</translation>
    </message>
    <message>
        <source>How far from a node points pull at it, in steps; more bridges wider gaps.</source>
        <translation>À quelle distance d’un nœud les points l’attirent, en pas&#xa0;; plus franchit des lacunes plus larges.</translation>
    </message>
    <message>
        <source>Kill distance</source>
        <translation>Distance d’élimination</translation>
    </message>
    <message>
        <source>Points nearer to a node are done with, in steps; less finds more twigs, and more spurs.</source>
        <translation>Les points plus proches d’un nœud sont traités, en pas&#xa0;; moins trouve plus de brindilles, et plus de rameaux courts.</translation>
    </message>
    <message>
        <source>What is clustered</source>
        <translation>Ce qui est regroupé</translation>
    </message>
    <message>
        <source>Directions lead from the node to its points; orientations are how the wood runs at each of these, as in the thesis.</source>
        <translation>Les directions mènent du nœud à ses points&#xa0;; les orientations sont la façon dont le bois court à chacun d’eux, comme dans la thèse.</translation>
    </message>
    <message>
        <source>Directions</source>
        <translation>Directions</translation>
    </message>
    <message>
        <source>Orientations</source>
        <translation>Orientations</translation>
    </message>
    <message>
        <source>Junction share</source>
        <translation>Part de jonction</translation>
    </message>
    <message>
        <source>0 puts nodes in the middle of their points, 1 where these meet those of the node before.</source>
        <translation>0 place les nœuds au milieu de leurs points, 1 là où ceux-ci rencontrent ceux du nœud précédent.</translation>
    </message>
    <message>
        <source>Graph colonization</source>
        <translation>Colonisation de graphe</translation>
    </message>
    <message>
        <source>Groups of points take the points behind them, in steps that follow the density.</source>
        <translation>Des groupes de points prennent les points derrière eux, par pas qui suivent la densité.</translation>
    </message>
    <message>
        <source>lets each piece take the points behind it, far in thick wood, near in twigs</source>
        <translation>laisse chaque morceau prendre les points derrière lui, loin dans le bois épais, près dans les brindilles</translation>
    </message>
    <message>
        <source>Cone angle</source>
        <translation>Angle du cône</translation>
    </message>
    <message>
        <source>Opening of the cones in which a node looks for children; less separates narrower forks apart.</source>
        <translation>Ouverture des cônes dans lesquels un nœud cherche des enfants&#xa0;; moins sépare des fourches plus étroites.</translation>
    </message>
    <message>
        <source>Fewest points</source>
        <translation>Minimum de points</translation>
    </message>
    <message>
        <source>Cones with fewer points bear no child.</source>
        <translation>Les cônes avec moins de points ne portent pas d’enfant.</translation>
    </message>
    <message>
        <source>Cluster density</source>
        <translation>Densité de regroupement</translation>
    </message>
    <message>
        <source>Where points are denser than this share of the densest, directions are clustered instead of sorted by cones; 1 is nowhere.</source>
        <translation>Là où les points sont plus denses que cette part de la plus grande densité, les directions sont regroupées au lieu d’être triées par cônes&#xa0;; 1 n’est nulle part.</translation>
    </message>
    <message>
        <source>Point tracking</source>
        <translation>Suivi de points</translation>
    </message>
    <message>
        <source>Follows the points from node to node, through cones, as the thesis does.</source>
        <translation>Suit les points de nœud en nœud, à travers des cônes, comme le fait la thèse.</translation>
    </message>
    <message>
        <source>follows the points from node to node, through cones, or by clusters of directions where points are dense</source>
        <translation>suit les points de nœud en nœud, à travers des cônes, ou par groupes de directions là où les points sont denses</translation>
    </message>
    <message>
        <source>Space colonization</source>
        <translation>Colonisation de l’espace</translation>
    </message>
    <message>
        <source>Points pull the nodes nearest to them; steps follow the density.</source>
        <translation>Les points attirent les nœuds les plus proches d’eux&#xa0;; les pas suivent la densité.</translation>
    </message>
    <message>
        <source>lets the points pull the nodes nearest to them</source>
        <translation>laisse les points attirer les nœuds les plus proches d’eux</translation>
    </message>
    <message>
        <source>Fit circles</source>
        <translation>Ajuster des cercles</translation>
    </message>
    <message>
        <source>Takes the center of a circle instead of the mean of the points where these cover one side of the wood.</source>
        <translation>Prend le centre d’un cercle au lieu de la moyenne des points là où ceux-ci couvrent un seul côté du bois.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Each point moves to the mean of the points within this distance along the plant. More than the radius of the thickest wood blurs twigs.</source>
        <translation>Chaque point va à la moyenne des points à moins de cette distance le long de la plante. Plus que le rayon du bois le plus épais brouille les brindilles.</translation>
    </message>
    <message>
        <source>Geodesic centroids</source>
        <translation>Centroïdes géodésiques</translation>
    </message>
    <message>
        <source>Moves each point to the mean of the points near it along the plant.</source>
        <translation>Déplace chaque point à la moyenne des points proches de lui le long de la plante.</translation>
    </message>
    <message>
        <source>all plants; the default</source>
        <translation>toutes les plantes&#xa0;; par défaut</translation>
    </message>
    <message>
        <source>Each point moves to the mean of the points within this distance in space. More than the gap between twigs draws them together.</source>
        <translation>Chaque point va à la moyenne des points à moins de cette distance dans l’espace. Plus que la lacune entre brindilles les rapproche.</translation>
    </message>
    <message>
        <source>Means of balls</source>
        <translation>Moyennes de boules</translation>
    </message>
    <message>
        <source>Moves each point to the mean of the points near it in space.</source>
        <translation>Déplace chaque point à la moyenne des points proches de lui dans l’espace.</translation>
    </message>
    <message>
        <source>a quick look; twigs far apart</source>
        <translation>un aperçu rapide&#xa0;; des brindilles éloignées entre elles</translation>
    </message>
    <message>
        <source>Density radius</source>
        <translation>Rayon de densité</translation>
    </message>
    <message>
        <source>Distance along the plant within which points are counted, to know how dense they lie.</source>
        <translation>Distance le long de la plante dans laquelle les points sont comptés, pour savoir combien ils sont denses.</translation>
    </message>
    <message>
        <source>Least radius</source>
        <translation>Rayon minimal</translation>
    </message>
    <message>
        <source>Radius where the points lie thinnest, as on twigs.</source>
        <translation>Rayon là où les points sont les plus clairsemés, comme sur les brindilles.</translation>
    </message>
    <message>
        <source>Greatest radius</source>
        <translation>Rayon maximal</translation>
    </message>
    <message>
        <source>Radius where the points lie densest, as on the trunk.</source>
        <translation>Rayon là où les points sont les plus denses, comme sur le tronc.</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Courbe</translation>
    </message>
    <message>
        <source>Exponent of the density between the two radii: above 1, only the densest wood gets a great one.</source>
        <translation>Exposant de la densité entre les deux rayons&#xa0;: au-dessus de 1, seul le bois le plus dense en a un grand.</translation>
    </message>
    <message>
        <source>Orientation radius</source>
        <translation>Rayon d’orientation</translation>
    </message>
    <message>
        <source>Distance along the plant within which its direction is measured; about three radii of the wood.</source>
        <translation>Distance le long de la plante dans laquelle sa direction est mesurée&#xa0;; environ trois rayons du bois.</translation>
    </message>
    <message>
        <source>Weight along</source>
        <translation>Poids en long</translation>
    </message>
    <message>
        <source>Weight of squared lengths along the wood: above 1, balls are slices.</source>
        <translation>Poids des carrés des longueurs le long du bois&#xa0;: au-dessus de 1, les boules sont des disques.</translation>
    </message>
    <message>
        <source>Weight across</source>
        <translation>Poids en travers</translation>
    </message>
    <message>
        <source>Weight of squared lengths across the wood: above 1, balls are rods.</source>
        <translation>Poids des carrés des longueurs en travers du bois&#xa0;: au-dessus de 1, les boules sont des bâtonnets.</translation>
    </message>
    <message>
        <source>Adaptive geodesic centroids</source>
        <translation>Centroïdes géodésiques adaptatifs</translation>
    </message>
    <message>
        <source>As geodesic centroids, with a radius that grows with the density of the points.</source>
        <translation>Comme les centroïdes géodésiques, avec un rayon qui croît avec la densité des points.</translation>
    </message>
    <message>
        <source>plants with thick and thin wood, scans from few sides</source>
        <translation>plantes à bois épais et mince, scans de peu de côtés</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Half of the thickness of a section, along the wood.</source>
        <translation>Moitié de l’épaisseur d’une section, le long du bois.</translation>
    </message>
    <message>
        <source>Adaptive sections</source>
        <translation>Sections adaptatives</translation>
    </message>
    <message>
        <source>Moves each point to the middle of the cross-section of the wood that it is on.</source>
        <translation>Déplace chaque point au milieu de la section transversale du bois sur lequel il est.</translation>
    </message>
    <message>
        <source>thick wood, trunks seen from one side</source>
        <translation>bois épais, troncs vus d’un seul côté</translation>
    </message>
    <message>
        <source>Leaves the points where they are.</source>
        <translation>Laisse les points où ils sont.</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>Points lower than this above the lowest are left out.</source>
        <translation>Les points à moins de cette hauteur au-dessus du plus bas sont écartés.</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>Points higher than this above the lowest are left out.</source>
        <translation>Les points à plus de cette hauteur au-dessus du plus bas sont écartés.</translation>
    </message>
    <message>
        <source>Slab</source>
        <translation>Tranche</translation>
    </message>
    <message>
        <source>Keeps what lies between two heights.</source>
        <translation>Garde ce qui est entre deux hauteurs.</translation>
    </message>
    <message>
        <source>Points farther from the stem than this are left out; the height does not count.</source>
        <translation>Les points plus loin de la tige que cela sont écartés&#xa0;; la hauteur ne compte pas.</translation>
    </message>
    <message>
        <source>Distance to the stem</source>
        <translation>Distance à la tige</translation>
    </message>
    <message>
        <source>Keeps what stands around the root that was chosen, or else around the foot of the plant.</source>
        <translation>Garde ce qui est autour de la racine choisie, ou sinon autour du pied de la plante.</translation>
    </message>
    <message>
        <source>Of the box, from left to right of the front view.</source>
        <translation>De la boîte, de gauche à droite de la vue de face.</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profondeur</translation>
    </message>
    <message>
        <source>Of the box, from front to back of the front view.</source>
        <translation>De la boîte, de l’avant à l’arrière de la vue de face.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Of the box, from the root up.</source>
        <translation>De la boîte, de la racine vers le haut.</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Boîte</translation>
    </message>
    <message>
        <source>Keeps what lies in a box on the root that was chosen, or else on the foot of the plant.</source>
        <translation>Garde ce qui est dans une boîte posée sur la racine choisie, ou sinon sur le pied de la plante.</translation>
    </message>
    <message>
        <source>the points have no colors, so all of them are kept</source>
        <translation>les points n’ont pas de couleurs, donc tous sont gardés</translation>
    </message>
    <message>
        <source>Least</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Points of less intensity are left out; 0 is the least of the scan, 1 the greatest.</source>
        <translation>Les points de moindre intensité sont écartés&#xa0;; 0 est la plus petite du scan, 1 la plus grande.</translation>
    </message>
    <message>
        <source>Most</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Points of more intensity are left out.</source>
        <translation>Les points de plus grande intensité sont écartés.</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>Intensité</translation>
    </message>
    <message>
        <source>Keeps points by how bright they returned.</source>
        <translation>Garde les points selon la force de leur retour.</translation>
    </message>
    <message>
        <source>the points have no intensities, so all of them are kept</source>
        <translation>les points n’ont pas d’intensités, donc tous sont gardés</translation>
    </message>
    <message>
        <source>Points with less of this color are left out.</source>
        <translation>Les points ayant moins de cette couleur sont écartés.</translation>
    </message>
    <message>
        <source>Points with more of this color are left out.</source>
        <translation>Les points ayant plus de cette couleur sont écartés.</translation>
    </message>
    <message>
        <source>Least red</source>
        <translation>Rouge minimal</translation>
    </message>
    <message>
        <source>Most red</source>
        <translation>Rouge maximal</translation>
    </message>
    <message>
        <source>Least green</source>
        <translation>Vert minimal</translation>
    </message>
    <message>
        <source>Most green</source>
        <translation>Vert maximal</translation>
    </message>
    <message>
        <source>Least blue</source>
        <translation>Bleu minimal</translation>
    </message>
    <message>
        <source>Most blue</source>
        <translation>Bleu maximal</translation>
    </message>
    <message>
        <source>Color</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Keeps points by how red, green and blue they are.</source>
        <translation>Garde les points selon leur quantité de rouge, de vert et de bleu.</translation>
    </message>
    <message>
        <source>Hues from here on are kept: 0 is red, 60 yellow, 120 green, 240 blue.</source>
        <translation>Les teintes à partir d’ici sont gardées&#xa0;: 0 est rouge, 60 jaune, 120 vert, 240 bleu.</translation>
    </message>
    <message>
        <source>Hues up to here are kept; less than From leads through red.</source>
        <translation>Les teintes jusqu’ici sont gardées&#xa0;; moins que «&#xa0;De&#xa0;» passe par le rouge.</translation>
    </message>
    <message>
        <source>Least saturation</source>
        <translation>Saturation minimale</translation>
    </message>
    <message>
        <source>Points of less colorful hues are left out.</source>
        <translation>Les points de teintes moins vives sont écartés.</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>Teinte</translation>
    </message>
    <message>
        <source>Keeps points by their hue.</source>
        <translation>Garde les points selon leur teinte.</translation>
    </message>
    <message>
        <source>Points that are less green are left out; grays have 0.</source>
        <translation>Les points moins verts sont écartés&#xa0;; les gris ont 0.</translation>
    </message>
    <message>
        <source>Points that are greener are left out: 0.1 leaves out leaves.</source>
        <translation>Les points plus verts sont écartés&#xa0;: 0.1 écarte les feuilles.</translation>
    </message>
    <message>
        <source>Greenness</source>
        <translation>Verdeur</translation>
    </message>
    <message>
        <source>Keeps points by how much greener than red and blue they are.</source>
        <translation>Garde les points selon leur excès de vert sur le rouge et le bleu.</translation>
    </message>
    <message>
        <source>Crops nothing.</source>
        <translation>Ne rogne rien.</translation>
    </message>
    <message>
        <source>Looks at no values of points.</source>
        <translation>Ne regarde aucune valeur des points.</translation>
    </message>
    <message>
        <source>Share within</source>
        <translation>Part intérieure</translation>
    </message>
    <message>
        <source>Share of the points that the crown is made of: the outermost are left out.</source>
        <translation>Part des points dont le houppier est fait&#xa0;: les plus extérieurs sont écartés.</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Boule</translation>
    </message>
    <message>
        <source>The smallest ball about all.</source>
        <translation>La plus petite boule autour de tout.</translation>
    </message>
    <message>
        <source>Ellipsoid</source>
        <translation>Ellipsoïde</translation>
    </message>
    <message>
        <source>The smallest ellipsoid about all; it may lean.</source>
        <translation>Le plus petit ellipsoïde autour de tout&#xa0;; il peut être incliné.</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Cylindre</translation>
    </message>
    <message>
        <source>The smallest upright cylinder about all.</source>
        <translation>Le plus petit cylindre vertical autour de tout.</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Cône</translation>
    </message>
    <message>
        <source>The smallest upright cone about all, its tip up.</source>
        <translation>Le plus petit cône vertical autour de tout, la pointe en haut.</translation>
    </message>
    <message>
        <source>Frustum</source>
        <translation>Tronc de cône</translation>
    </message>
    <message>
        <source>The smallest upright truncated cone about all; it may be wider above.</source>
        <translation>Le plus petit tronc de cône vertical autour de tout&#xa0;; il peut être plus large en haut.</translation>
    </message>
    <message>
        <source>Paraboloid</source>
        <translation>Paraboloïde</translation>
    </message>
    <message>
        <source>The smallest upright paraboloid about all, round above and flat below.</source>
        <translation>Le plus petit paraboloïde vertical autour de tout, rond en haut et plat en bas.</translation>
    </message>
    <message>
        <source>The smallest upright box about all.</source>
        <translation>La plus petite boîte verticale autour de tout.</translation>
    </message>
    <message>
        <source>Seen lengthwise</source>
        <translation>Vu en longueur</translation>
    </message>
    <message>
        <source>Take the side profile along the length of the crown as seen from above, not across it.</source>
        <translation>Prendre le profil de côté le long du houppier vu de dessus, et non en travers.</translation>
    </message>
    <message>
        <source>Extruded hull</source>
        <translation>Enveloppe extrudée</translation>
    </message>
    <message>
        <source>The outline from above, moved along the outline from the side and scaled to it.</source>
        <translation>Le contour vu de dessus, déplacé le long du contour de côté et mis à son échelle.</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Profils</translation>
    </message>
    <message>
        <source>How many upright profiles there are around the axis.</source>
        <translation>Combien de profils verticaux il y a autour de l’axe.</translation>
    </message>
    <message>
        <source>Skinned hull</source>
        <translation>Enveloppe tendue</translation>
    </message>
    <message>
        <source>Upright profiles around an axis, with a skin drawn over them.</source>
        <translation>Des profils verticaux autour d’un axe, avec une peau tendue sur eux.</translation>
    </message>
    <message>
        <source>Ball radius</source>
        <translation>Rayon de la boule</translation>
    </message>
    <message>
        <source>Radius of a ball that is rolled around the points: gaps that it goes into stay outside.</source>
        <translation>Rayon d’une boule que l’on roule autour des points&#xa0;: les lacunes où elle entre restent dehors.</translation>
    </message>
    <message>
        <source>Fill hollows</source>
        <translation>Remplir les creux</translation>
    </message>
    <message>
        <source>Hollows that no path leads into from outside count as inside.</source>
        <translation>Les creux où aucun chemin ne mène de l’extérieur comptent comme intérieur.</translation>
    </message>
    <message>
        <source>Alpha hull</source>
        <translation>Enveloppe alpha</translation>
    </message>
    <message>
        <source>What a ball cannot reach that is rolled around and among the points.</source>
        <translation>Ce que ne peut atteindre une boule roulée autour des points et parmi eux.</translation>
    </message>
    <message>
        <source>Asymmetric hull</source>
        <translation>Enveloppe asymétrique</translation>
    </message>
    <message>
        <source>A crown by its top, its bottom, its widest places to four sides and an exponent above and below.</source>
        <translation>Un houppier par son sommet, sa base, ses endroits les plus larges de quatre côtés et un exposant au-dessus et au-dessous.</translation>
    </message>
    <message>
        <source>Convex hull</source>
        <translation>Enveloppe convexe</translation>
    </message>
    <message>
        <source>The smallest body about all that is hollow nowhere.</source>
        <translation>Le plus petit corps autour de tout qui n’est creux nulle part.</translation>
    </message>
    <message>
        <source>Envelope</source>
        <translation>Enveloppe</translation>
    </message>
    <message>
        <source>Draws a closed surface about the crown.</source>
        <translation>Trace une surface fermée autour du houppier.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>Links per point along which distances are measured; more bridge wider gaps.</source>
        <translation>Liaisons par point le long desquelles les distances sont mesurées&#xa0;; plus franchit des lacunes plus larges.</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Liaisons</translation>
    </message>
    <message>
        <source>Which neighbors points are linked to. All around and Voronoi link the lines in which a scanner samples a surface, where the nearest points are all of one line; they choose of three times as many.</source>
        <translation>À quels voisins les points sont liés. «&#xa0;Tout autour&#xa0;» et «&#xa0;Voronoï&#xa0;» lient les lignes par lesquelles un scanner échantillonne une surface, où les points les plus proches sont tous d’une même ligne&#xa0;; elles choisissent parmi trois fois plus.</translation>
    </message>
    <message>
        <source>Nearest</source>
        <translation>Les plus proches</translation>
    </message>
    <message>
        <source>All around</source>
        <translation>Tout autour</translation>
    </message>
    <message>
        <source>Voronoi</source>
        <translation>Voronoï</translation>
    </message>
    <message>
        <source>Densities</source>
        <translation>Densités</translation>
    </message>
    <message>
        <source>By range, a density counts by its place between the thinnest and the densest; by rank, by the share of the points that lie thinner, so that few dense places do not make all others thin.</source>
        <translation>Par étendue, une densité compte par sa place entre la plus clairsemée et la plus dense&#xa0;; par rang, par la part des points qui sont plus clairsemés, afin que peu d’endroits denses ne rendent pas tous les autres clairsemés.</translation>
    </message>
    <message>
        <source>By range</source>
        <translation>Par étendue</translation>
    </message>
    <message>
        <source>By rank</source>
        <translation>Par rang</translation>
    </message>
    <message>
        <source>Parts of the plant farther apart than this are not joined; 0 joins all.</source>
        <translation>Les parties de la plante plus éloignées entre elles que cela ne sont pas jointes&#xa0;; 0 joint tout.</translation>
    </message>
    <message>
        <source>Thick wood</source>
        <translation>Bois épais</translation>
    </message>
    <message>
        <source>Points of wood thicker than this are drawn to its axis first, or they would leave strands on it; 0 draws none.</source>
        <translation>Les points d’un bois plus épais que cela sont d’abord ramenés à son axe, sinon ils y laisseraient des brins&#xa0;; 0 n’en ramène aucun.</translation>
    </message>
    <message>
        <source>Least coverage</source>
        <translation>Couverture minimale</translation>
    </message>
    <message>
        <source>Share of the circumference that points must cover before a fit is trusted.</source>
        <translation>Part de la circonférence que les points doivent couvrir pour qu’un ajustement soit jugé fiable.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>How much of the wood a cylinder is fitted to, in radii.</source>
        <translation>Sur quelle longueur du bois un cylindre est ajusté, en rayons.</translation>
    </message>
    <message>
        <source>Links per point along which distances are measured.</source>
        <translation>Liaisons par point le long desquelles les distances sont mesurées.</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Écarter</translation>
    </message>
    <message>
        <source>Which organs are left out. Stems of herbs and grasses count as wood.</source>
        <translation>Quels organes sont écartés. Les tiges des herbacées et des graminées comptent comme bois.</translation>
    </message>
    <message>
        <source>Blades and needles</source>
        <translation>Limbes et aiguilles</translation>
    </message>
    <message>
        <source>Blades</source>
        <translation>Limbes</translation>
    </message>
    <message>
        <source>Needles</source>
        <translation>Aiguilles</translation>
    </message>
    <message>
        <source>All but wood</source>
        <translation>Tout sauf le bois</translation>
    </message>
    <message>
        <source>By shape</source>
        <translation>Par la forme</translation>
    </message>
    <message>
        <source>Classifies points as wood, petioles, blades and needles by the shapes around each point and by the paths to the root, and leaves out leaves.</source>
        <translation>Classe les points en bois, pétioles, limbes et aiguilles par les formes autour de chaque point et par les chemins vers la racine, et écarte les feuilles.</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Liaison</translation>
    </message>
    <message>
        <source>Points of blades farther apart than this are of two blades, in point spacings of the blades.</source>
        <translation>Les points de limbes plus éloignés entre eux que cela sont de deux limbes, en espacements des points des limbes.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Distance between the nodes of an axis, in point spacings of the blades.</source>
        <translation>Distance entre les nœuds d’un axe, en espacements des points des limbes.</translation>
    </message>
    <message>
        <source>Least length</source>
        <translation>Longueur minimale</translation>
    </message>
    <message>
        <source>Shorter pieces of blades get no axis.</source>
        <translation>Les morceaux de limbe plus courts n’ont pas d’axe.</translation>
    </message>
    <message>
        <source>Blades farther from the wood than this get no axis.</source>
        <translation>Les limbes plus loin du bois que cela n’ont pas d’axe.</translation>
    </message>
    <message>
        <source>Midlines</source>
        <translation>Lignes médianes</translation>
    </message>
    <message>
        <source>Gives each blade that the step Leaves left out one axis, along its midline.</source>
        <translation>Donne à chaque limbe que l’étape Feuilles a écarté un axe, le long de sa ligne médiane.</translation>
    </message>
    <message>
        <source>Gives blades no axes.</source>
        <translation>Ne donne pas d’axes aux limbes.</translation>
    </message>
    <message>
        <source>Keeps leaves and needles.</source>
        <translation>Garde les feuilles et les aiguilles.</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Espacement</translation>
    </message>
    <message>
        <source>Greatest distance between nodes.</source>
        <translation>Distance maximale entre les nœuds.</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Puissance</translation>
    </message>
    <message>
        <source>A link costs its length to this power; more avoids leaps over gaps.</source>
        <translation>Une liaison coûte sa longueur à cette puissance&#xa0;; plus évite les sauts par-dessus les lacunes.</translation>
    </message>
    <message>
        <source>Least share</source>
        <translation>Part minimale</translation>
    </message>
    <message>
        <source>Branches go whose longest path is a smaller share of that of their wood.</source>
        <translation>Partent les branches dont le plus long chemin est une plus petite part de celui de leur bois.</translation>
    </message>
    <message>
        <source>Merge angle</source>
        <translation>Angle de fusion</translation>
    </message>
    <message>
        <source>Branches side by side at less than this may be one.</source>
        <translation>Les branches côte à côte à moins de cet angle peuvent n’en être qu’une.</translation>
    </message>
    <message>
        <source>How far points lie off the axis even of a twig; more merges more.</source>
        <translation>À quelle distance de l’axe sont les points, même d’une brindille&#xa0;; plus fusionne davantage.</translation>
    </message>
    <message>
        <source>Shortest paths</source>
        <translation>Plus courts chemins</translation>
    </message>
    <message>
        <source>Simplifies the tree of shortest paths, by squared length, over all points.</source>
        <translation>Simplifie l’arbre des plus courts chemins, par longueur au carré, sur tous les points.</translation>
    </message>
    <message>
        <source>simplifies the tree of shortest paths over all points</source>
        <translation>simplifie l’arbre des plus courts chemins sur tous les points</translation>
    </message>
    <message>
        <source>Rounds</source>
        <translation>Passes</translation>
    </message>
    <message>
        <source>How often branches are made straighter.</source>
        <translation>Combien de fois les branches sont rendues plus droites.</translation>
    </message>
    <message>
        <source>Radius share</source>
        <translation>Part de rayon</translation>
    </message>
    <message>
        <source>Mean radius of the wood, in mean distances of the points from it; more merges more.</source>
        <translation>Rayon moyen du bois, en distances moyennes des points à celui-ci&#xa0;; plus fusionne davantage.</translation>
    </message>
    <message>
        <source>Least edge</source>
        <translation>Arête minimale</translation>
    </message>
    <message>
        <source>Shorter edges go; 0 is the shortest, 1 the longest of all.</source>
        <translation>Les arêtes plus courtes partent&#xa0;; 0 est la plus courte, 1 la plus longue de toutes.</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Recouvrement</translation>
    </message>
    <message>
        <source>Branches whose wood overlaps by more than this share become one.</source>
        <translation>Les branches dont le bois se recouvre de plus que cette part n’en font plus qu’une.</translation>
    </message>
    <message>
        <source>Branch structure graph</source>
        <translation>Graphe de structure des branches</translation>
    </message>
    <message>
        <source>Straightens the tree of shortest paths over all points, and merges what overlaps.</source>
        <translation>Redresse l’arbre des plus courts chemins sur tous les points, et fusionne ce qui se recouvre.</translation>
    </message>
    <message>
        <source>straightens such a tree, and merges what overlaps</source>
        <translation>redresse un tel arbre, et fusionne ce qui se recouvre</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Par défaut</translation>
    </message>
    <message>
        <source>The best of all methods; every option follows from the scan.</source>
        <translation>La meilleure de toutes les méthodes&#xa0;; chaque option découle du scan.</translation>
    </message>
    <message>
        <source>As in the Thesis</source>
        <translation>Comme dans la thèse</translation>
    </message>
    <message>
        <source>Adaptive contraction, point tracking and pipe model, with the settings of the thesis.</source>
        <translation>Contraction adaptative, suivi de points et modèle des tuyaux, avec les réglages de la thèse.</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>Feuilles</translation>
    </message>
    <message>
        <source>For herbs, seedlings and grasses with large leaves: fewer ends, only those that are quite probably shoots or midribs; all else as by default.</source>
        <translation>Pour les herbacées, plantules et graminées à grandes feuilles&#xa0;: moins d’extrémités, seulement celles qui sont très probablement des pousses ou des nervures médianes&#xa0;; le reste par défaut.</translation>
    </message>
    <message>
        <source>Tree without Leaves</source>
        <translation>Arbre sans feuilles</translation>
    </message>
    <message>
        <source>Tree with Needles</source>
        <translation>Arbre à aiguilles</translation>
    </message>
    <message>
        <source>Tree in Leaf</source>
        <translation>Arbre feuillé</translation>
    </message>
    <message>
        <source>Herb</source>
        <translation>Herbacée</translation>
    </message>
    <message>
        <source>Grass</source>
        <translation>Graminée</translation>
    </message>
    <message>
        <source>From a Plot</source>
        <translation>D’une placette</translation>
    </message>
    <message>
        <source>Leaves out ground, poles, wires and other plants; all else as by default.</source>
        <translation>Écarte le sol, les poteaux, les câbles et les autres plantes&#xa0;; le reste par défaut.</translation>
    </message>
    <message>
        <source>Branch limit</source>
        <translation>Limite des branches</translation>
    </message>
    <message>
        <source>A branch is at most this share as thick as the wood that bears it.</source>
        <translation>Une branche a au plus cette part de l’épaisseur du bois qui la porte.</translation>
    </message>
    <message>
        <source>Cylinder fits</source>
        <translation>Cylindres ajustés</translation>
    </message>
    <message>
        <source>Radii of cylinders fitted to the wood about each node, which stray points do not pull.</source>
        <translation>Rayons de cylindres ajustés au bois autour de chaque nœud, que les points isolés n’attirent pas.</translation>
    </message>
    <message>
        <source>Step along an axis</source>
        <translation>Pas le long d’un axe</translation>
    </message>
    <message>
        <source>How much the radius may stray from the model from node to node: more follows each measurement.</source>
        <translation>De combien le rayon peut s’écarter du modèle de nœud en nœud&#xa0;: plus suit chaque mesure.</translation>
    </message>
    <message>
        <source>Step to a branch</source>
        <translation>Pas vers une branche</translation>
    </message>
    <message>
        <source>The same from an axis to a branch.</source>
        <translation>La même chose d’un axe à une branche.</translation>
    </message>
    <message>
        <source>Cylinders and pipe model</source>
        <translation>Cylindres et modèle des tuyaux</translation>
    </message>
    <message>
        <source>Radii of fitted cylinders where points suffice, of a pipe model fitted to them elsewhere, each as far as it can be trusted.</source>
        <translation>Rayons de cylindres ajustés là où les points suffisent, d’un modèle des tuyaux ajusté à ceux-ci ailleurs, chacun pour autant qu’il est fiable.</translation>
    </message>
    <message>
        <source>Node-count pipe model</source>
        <translation>Modèle des tuyaux par nœuds</translation>
    </message>
    <message>
        <source>Radii grow with the number of nodes carried, between those measured at the foot and at the tips.</source>
        <translation>Les rayons croissent avec le nombre de nœuds portés, entre ceux mesurés au pied et aux extrémités.</translation>
    </message>
    <message>
        <source>Length pipe model</source>
        <translation>Modèle des tuyaux par longueur</translation>
    </message>
    <message>
        <source>Radii grow with the length of the wood carried, between those measured at the foot and at the tips; node spacing does not matter.</source>
        <translation>Les rayons croissent avec la longueur du bois porté, entre ceux mesurés au pied et aux extrémités&#xa0;; l’espacement des nœuds ne compte pas.</translation>
    </message>
    <message>
        <source>Exponent</source>
        <translation>Exposant</translation>
    </message>
    <message>
        <source>How fast radii grow with the logarithm of the length carried.</source>
        <translation>À quelle vitesse les rayons croissent avec le logarithme de la longueur portée.</translation>
    </message>
    <message>
        <source>Average-constrained pipe model</source>
        <translation>Modèle des tuyaux à moyenne imposée</translation>
    </message>
    <message>
        <source>Radii grow with the length of the wood carried; their mean is the mean distance of the points to the skeleton.</source>
        <translation>Les rayons croissent avec la longueur du bois porté&#xa0;; leur moyenne est la distance moyenne des points au squelette.</translation>
    </message>
    <message>
        <source>Mean distance</source>
        <translation>Distance moyenne</translation>
    </message>
    <message>
        <source>Mean distance of the points of each node to the skeleton.</source>
        <translation>Distance moyenne des points de chaque nœud au squelette.</translation>
    </message>
    <message>
        <source>Maximum distance</source>
        <translation>Distance maximale</translation>
    </message>
    <message>
        <source>Distance that 95 % of the points of each node are nearer than.</source>
        <translation>Distance à moins de laquelle sont 95&#xa0;% des points de chaque nœud.</translation>
    </message>
    <message>
        <source>Hull</source>
        <translation>Enveloppe convexe</translation>
    </message>
    <message>
        <source>Length around the convex hull of the points of each node.</source>
        <translation>Longueur autour de l’enveloppe convexe des points de chaque nœud.</translation>
    </message>
    <message>
        <source>Crop</source>
        <translation>Rogner</translation>
    </message>
    <message>
        <source>Keeps a part of the scan.</source>
        <translation>Garde une partie du scan.</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>Keeps points by their intensity or color.</source>
        <translation>Garde les points selon leur intensité ou leur couleur.</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>Leaves out the ground.</source>
        <translation>Écarte le sol.</translation>
    </message>
    <message>
        <source>Poles</source>
        <translation>Poteaux</translation>
    </message>
    <message>
        <source>Leaves out poles and stakes.</source>
        <translation>Écarte les poteaux et les piquets.</translation>
    </message>
    <message>
        <source>Wires</source>
        <translation>Câbles</translation>
    </message>
    <message>
        <source>Leaves out wires and ropes.</source>
        <translation>Écarte les câbles et les cordes.</translation>
    </message>
    <message>
        <source>Plant</source>
        <translation>Plante</translation>
    </message>
    <message>
        <source>Keeps one of several plants.</source>
        <translation>Garde une plante parmi plusieurs.</translation>
    </message>
    <message>
        <source>Thin</source>
        <translation>Éclaircir</translation>
    </message>
    <message>
        <source>Keeps fewer points.</source>
        <translation>Garde moins de points.</translation>
    </message>
    <message>
        <source>Leaves out leaves and needles.</source>
        <translation>Écarte les feuilles et les aiguilles.</translation>
    </message>
    <message>
        <source>Clean</source>
        <translation>Nettoyer</translation>
    </message>
    <message>
        <source>Leaves out points that are no plant.</source>
        <translation>Écarte les points qui ne sont pas de la plante.</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Lisser</translation>
    </message>
    <message>
        <source>Moves the points to the surface of the wood that they sample.</source>
        <translation>Déplace les points à la surface du bois qu’ils échantillonnent.</translation>
    </message>
    <message>
        <source>Contract</source>
        <translation>Contracter</translation>
    </message>
    <message>
        <source>Pulls the points towards the axes of the plant.</source>
        <translation>Tire les points vers les axes de la plante.</translation>
    </message>
    <message>
        <source>Skeleton</source>
        <translation>Squelette</translation>
    </message>
    <message>
        <source>Finds nodes and their attachments.</source>
        <translation>Trouve les nœuds et leurs points d’attache.</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Joindre</translation>
    </message>
    <message>
        <source>Chooses the attachments across gaps.</source>
        <translation>Choisit les points d’attache à travers les lacunes.</translation>
    </message>
    <message>
        <source>Prune</source>
        <translation>Élaguer</translation>
    </message>
    <message>
        <source>Removes what is no branch.</source>
        <translation>Supprime ce qui n’est pas une branche.</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <source>Chooses which child continues the axis.</source>
        <translation>Choisit quel enfant continue l’axe.</translation>
    </message>
    <message>
        <source>Recenter</source>
        <translation>Recentrer</translation>
    </message>
    <message>
        <source>Moves nodes into the middle of the wood.</source>
        <translation>Déplace les nœuds au milieu du bois.</translation>
    </message>
    <message>
        <source>Insertions</source>
        <translation>Insertions</translation>
    </message>
    <message>
        <source>Attaches branches where they leave the wood that bears them.</source>
        <translation>Attache les branches là où elles quittent le bois qui les porte.</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Extrémités</translation>
    </message>
    <message>
        <source>Gives tips and roots their full length.</source>
        <translation>Donne aux extrémités et aux racines leur pleine longueur.</translation>
    </message>
    <message>
        <source>Draws axes of blades that were left out.</source>
        <translation>Trace les axes des limbes qui ont été écartés.</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>Nœuds</translation>
    </message>
    <message>
        <source>Spaces the nodes.</source>
        <translation>Espace les nœuds.</translation>
    </message>
    <message>
        <source>Gives each node its radius.</source>
        <translation>Donne à chaque nœud son rayon.</translation>
    </message>
    <message>
        <source>Longest edge</source>
        <translation>Arête maximale</translation>
    </message>
    <message>
        <source>Edges longer than this, and than the wood at their ends is thick, bridge a gap: what they lead to may be attached elsewhere.</source>
        <translation>Les arêtes plus longues que cela, et que l’épaisseur du bois à leurs extrémités, franchissent une lacune&#xa0;: ce à quoi elles mènent peut être attaché ailleurs.</translation>
    </message>
    <message>
        <source>How far across a gap wood is looked for.</source>
        <translation>Jusqu’à quelle distance à travers une lacune le bois est cherché.</translation>
    </message>
    <message>
        <source>Across gaps by odds</source>
        <translation>Lacunes par probabilités</translation>
    </message>
    <message>
        <source>Attaches what lies beyond gaps by the links that are together the most probable.</source>
        <translation>Attache ce qui est au-delà des lacunes par les liaisons qui sont ensemble les plus probables.</translation>
    </message>
    <message>
        <source>Cost of turns</source>
        <translation>Coût des virages</translation>
    </message>
    <message>
        <source>How much more a link costs that turns back than one straight on.</source>
        <translation>De combien une liaison qui revient en arrière coûte plus qu’une liaison droite.</translation>
    </message>
    <message>
        <source>Cost of branches that point back</source>
        <translation>Coût des branches vers l’arrière</translation>
    </message>
    <message>
        <source>What each branch costs that would point back to where its wood begins.</source>
        <translation>Ce que coûte chaque branche qui pointerait en arrière vers où son bois commence.</translation>
    </message>
    <message>
        <source>Across gaps by direction</source>
        <translation>Lacunes par direction</translation>
    </message>
    <message>
        <source>Attaches what lies beyond gaps to the wood that it goes on from, by direction, radius and distance, for all at once.</source>
        <translation>Attache ce qui est au-delà des lacunes au bois qu’il prolonge, par direction, rayon et distance, pour tout à la fois.</translation>
    </message>
    <message>
        <source>Edges of the axis below, up and down from the branch, that are looked at.</source>
        <translation>Arêtes de l’axe porteur, en montant et en descendant depuis la branche, qui sont examinées.</translation>
    </message>
    <message>
        <source>Near a node</source>
        <translation>Près d’un nœud</translation>
    </message>
    <message>
        <source>Share of an edge within which a branch goes to the node there, not to a new one.</source>
        <translation>Part d’une arête dans laquelle une branche va au nœud qui est là, et non à un nouveau.</translation>
    </message>
    <message>
        <source>Weight of the node</source>
        <translation>Poids du nœud</translation>
    </message>
    <message>
        <source>How much the node counts that a branch was found on; its line counts 1 where it meets the axis at a right angle, less where it is flatter.</source>
        <translation>Combien compte le nœud où une branche a été trouvée&#xa0;; sa ligne compte 1 là où elle rencontre l’axe à angle droit, moins là où elle est plus rasante.</translation>
    </message>
    <message>
        <source>Gather</source>
        <translation>Regrouper</translation>
    </message>
    <message>
        <source>Branches that leave the axis nearer to each other than this leave it at one place.</source>
        <translation>Les branches qui quittent l’axe plus près l’une de l’autre que cela le quittent à un même endroit.</translation>
    </message>
    <message>
        <source>Slide along the axis</source>
        <translation>Glisser le long de l’axe</translation>
    </message>
    <message>
        <source>Attaches each branch nearer to where its first edges, drawn on backwards, meet the axis.</source>
        <translation>Attache chaque branche plus près de là où ses premières arêtes, prolongées en arrière, rencontrent l’axe.</translation>
    </message>
    <message>
        <source>Wanted length of edges, between nodes that stay: branchings and ends.</source>
        <translation>Longueur voulue des arêtes, entre les nœuds qui restent&#xa0;: ramifications et extrémités.</translation>
    </message>
    <message>
        <source>Even spacing</source>
        <translation>Espacement régulier</translation>
    </message>
    <message>
        <source>Spaces nodes evenly along each unbranched stretch.</source>
        <translation>Espace les nœuds régulièrement le long de chaque tronçon non ramifié.</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>How far a node that is left out may lie from the line between its neighbors.</source>
        <translation>À quelle distance de la ligne entre ses voisins peut être un nœud qui est écarté.</translation>
    </message>
    <message>
        <source>By curvature</source>
        <translation>Par la courbure</translation>
    </message>
    <message>
        <source>Leaves out nodes where axes are straight, so that there are many where they bend.</source>
        <translation>Écarte des nœuds là où les axes sont droits, de sorte qu’il y en a beaucoup là où ils se courbent.</translation>
    </message>
    <message>
        <source>How far each node moves to the mean of its neighbors on the axis.</source>
        <translation>De combien chaque nœud va vers la moyenne de ses voisins sur l’axe.</translation>
    </message>
    <message>
        <source>How often.</source>
        <translation>Combien de fois.</translation>
    </message>
    <message>
        <source>Smooths each axis; its ends stay.</source>
        <translation>Lisse chaque axe&#xa0;; ses extrémités restent.</translation>
    </message>
    <message>
        <source>Keeps the shortest bridges.</source>
        <translation>Garde les ponts les plus courts.</translation>
    </message>
    <message>
        <source>Leaves branches on the nodes they were found at.</source>
        <translation>Laisse les branches sur les nœuds où elles ont été trouvées.</translation>
    </message>
    <message>
        <source>Leaves the nodes as they are.</source>
        <translation>Laisse les nœuds comme ils sont.</translation>
    </message>
    <message>
        <source>Least probability</source>
        <translation>Probabilité minimale</translation>
    </message>
    <message>
        <source>Ends that are less probably shoots are removed; 0 keeps all that are long enough.</source>
        <translation>Les extrémités qui sont moins probablement des pousses sont supprimées&#xa0;; 0 garde toutes celles qui sont assez longues.</translation>
    </message>
    <message>
        <source>Unbranched ends shorter than this are removed.</source>
        <translation>Les extrémités non ramifiées plus courtes que cela sont supprimées.</translation>
    </message>
    <message>
        <source>By probability</source>
        <translation>Par la probabilité</translation>
    </message>
    <message>
        <source>Removes ends that are probably no shoots, by how far they stand out, what bears them, and the points that only they explain.</source>
        <translation>Supprime les extrémités qui ne sont probablement pas des pousses, d’après leur saillie, ce qui les porte, et les points qu’elles seules expliquent.</translation>
    </message>
    <message>
        <source>This many radii of the wood they stand on are added to that length.</source>
        <translation>Ce nombre de rayons du bois sur lequel elles sont est ajouté à cette longueur.</translation>
    </message>
    <message>
        <source>Remove spurs</source>
        <translation>Supprimer les rameaux courts</translation>
    </message>
    <message>
        <source>Removes short unbranched ends, shortest first.</source>
        <translation>Supprime les courtes extrémités non ramifiées, les plus courtes d’abord.</translation>
    </message>
    <message>
        <source>How often nodes are moved and smoothed.</source>
        <translation>Combien de fois les nœuds sont déplacés et lissés.</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Lissage</translation>
    </message>
    <message>
        <source>Sharpest turn</source>
        <translation>Virage maximal</translation>
    </message>
    <message>
        <source>An axis never turns more than this where it branches.</source>
        <translation>Un axe ne tourne jamais de plus que cela là où il se ramifie.</translation>
    </message>
    <message>
        <source>Edges before and behind a node over which its turn is measured.</source>
        <translation>Arêtes avant et après un nœud sur lesquelles son virage est mesuré.</translation>
    </message>
    <message>
        <source>Heaviest child</source>
        <translation>Enfant le plus lourd</translation>
    </message>
    <message>
        <source>The child that carries most continues the axis, unless it turns off too sharply.</source>
        <translation>L’enfant qui porte le plus continue l’axe, à moins qu’il ne tourne trop fort.</translation>
    </message>
    <message>
        <source>Weight of what it carries</source>
        <translation>Poids de ce qu’il porte</translation>
    </message>
    <message>
        <source>What a child loses per halving of the length that it carries.</source>
        <translation>Ce qu’un enfant perd chaque fois que la longueur qu’il porte est divisée par deux.</translation>
    </message>
    <message>
        <source>Weight of straightness</source>
        <translation>Poids de la rectitude</translation>
    </message>
    <message>
        <source>What a child loses per turn by 60 degrees.</source>
        <translation>Ce qu’un enfant perd par virage de 60 degrés.</translation>
    </message>
    <message>
        <source>Weight of thickness</source>
        <translation>Poids de l’épaisseur</translation>
    </message>
    <message>
        <source>What a child loses per halving of its radius.</source>
        <translation>Ce qu’un enfant perd chaque fois que son rayon est divisé par deux.</translation>
    </message>
    <message>
        <source>Weighed</source>
        <translation>Pondéré</translation>
    </message>
    <message>
        <source>The child that is heavy, straight and thick continues the axis, unless it turns off too sharply.</source>
        <translation>L’enfant qui est lourd, droit et épais continue l’axe, à moins qu’il ne tourne trop fort.</translation>
    </message>
    <message>
        <source>Share of a circle that points must cover before a fitted circle is trusted.</source>
        <translation>Part d’un cercle que les points doivent couvrir pour qu’un cercle ajusté soit jugé fiable.</translation>
    </message>
    <message>
        <source>Straight reach</source>
        <translation>Portée droite</translation>
    </message>
    <message>
        <source>Between two trusted circles so near, in radii, wood is taken as straight: there branches pull nodes aside.</source>
        <translation>Entre deux cercles fiables aussi proches, en rayons, le bois est pris pour droit&#xa0;: là, les branches tirent les nœuds de côté.</translation>
    </message>
    <message>
        <source>Recenter on sections</source>
        <translation>Recentrer sur les sections</translation>
    </message>
    <message>
        <source>Moves nodes to the centers of circles fitted to the wood around them and smooths the axes.</source>
        <translation>Déplace les nœuds aux centres de cercles ajustés au bois autour d’eux et lisse les axes.</translation>
    </message>
    <message>
        <source>Recenter on cylinders</source>
        <translation>Recentrer sur les cylindres</translation>
    </message>
    <message>
        <source>Moves nodes onto the axes of cylinders fitted to the wood around them, which finds the middle of wood scanned from one side, and smooths the axes.</source>
        <translation>Déplace les nœuds sur les axes de cylindres ajustés au bois autour d’eux, ce qui trouve le milieu du bois scanné d’un seul côté, et lisse les axes.</translation>
    </message>
    <message>
        <source>Extend to the points</source>
        <translation>Prolonger jusqu’aux points</translation>
    </message>
    <message>
        <source>Lengthens tips and roots to the points that contraction pulled inwards, and lays the foot of thick wood on its axis.</source>
        <translation>Allonge les extrémités et les racines jusqu’aux points que la contraction a tirés vers l’intérieur, et pose le pied du bois épais sur son axe.</translation>
    </message>
    <message>
        <source>Keeps all branches.</source>
        <translation>Garde toutes les branches.</translation>
    </message>
    <message>
        <source>Leaves the nodes where they are.</source>
        <translation>Laisse les nœuds où ils sont.</translation>
    </message>
    <message>
        <source>Leaves the ends where they are.</source>
        <translation>Laisse les extrémités où elles sont.</translation>
    </message>
    <message>
        <source>Bin width</source>
        <translation>Largeur des classes</translation>
    </message>
    <message>
        <source>Distance between nodes along the plant. Less finds more twigs, and more spurs.</source>
        <translation>Distance entre les nœuds le long de la plante. Moins trouve plus de brindilles, et plus de rameaux courts.</translation>
    </message>
    <message>
        <source>How much more a link costs across the wood than along it, when twigs touch; 0 takes the shortest path.</source>
        <translation>De combien une liaison coûte plus en travers du bois que le long de celui-ci, quand des brindilles se touchent&#xa0;; 0 prend le plus court chemin.</translation>
    </message>
    <message>
        <source>Geodesic bins</source>
        <translation>Classes géodésiques</translation>
    </message>
    <message>
        <source>One node per connected part of each bin of the distance to the root.</source>
        <translation>Un nœud par partie connexe de chaque classe de distance à la racine.</translation>
    </message>
    <message>
        <source>cuts the plant into pieces of equal distance to the root</source>
        <translation>coupe la plante en morceaux d’égale distance à la racine</translation>
    </message>
    <message>
        <source>How far around a point others count. More than the radius of the wood leaves it as it is, less than twice the noise smooths little.</source>
        <translation>Jusqu’où autour d’un point les autres comptent. Plus que le rayon du bois le laisse tel quel, moins de deux fois le bruit lisse peu.</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Itérations</translation>
    </message>
    <message>
        <source>How often points are moved, each time to the surface of where they are then.</source>
        <translation>Combien de fois les points sont déplacés, chaque fois à la surface de là où ils sont alors.</translation>
    </message>
    <message>
        <source>Leaves the points where they were scanned.</source>
        <translation>Laisse les points où ils ont été scannés.</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Plans</translation>
    </message>
    <message>
        <source>Moves each point to a plane that is fitted to those near it. Smooths most; curved wood gets a little thinner.</source>
        <translation>Déplace chaque point sur un plan ajusté à ceux proches de lui. Lisse le plus&#xa0;; le bois courbe s’amincit un peu.</translation>
    </message>
    <message>
        <source>Spheres</source>
        <translation>Sphères</translation>
    </message>
    <message>
        <source>Moves each point to an algebraic sphere that is fitted to those near it. Keeps the thickness of curved wood; smooths less than planes.</source>
        <translation>Déplace chaque point sur une sphère algébrique ajustée à ceux proches de lui. Garde l’épaisseur du bois courbe&#xa0;; lisse moins que les plans.</translation>
    </message>
    <message>
        <source>How many of the nearest points each one moves to the mean of.</source>
        <translation>Le nombre de points les plus proches à la moyenne desquels chacun va.</translation>
    </message>
    <message>
        <source>One Laplacian step</source>
        <translation>Un pas laplacien</translation>
    </message>
    <message>
        <source>Moves each point to the mean of its nearest ones: a slight smoothing.</source>
        <translation>Déplace chaque point à la moyenne des plus proches&#xa0;: un léger lissage.</translation>
    </message>
    <message>
        <source>smoothing of noise, hardly a contraction</source>
        <translation>lissage du bruit, guère une contraction</translation>
    </message>
    <message>
        <source>How many of the nearest points the ring about each one is chosen from.</source>
        <translation>Le nombre de points les plus proches parmi lesquels est choisi l’anneau autour de chacun.</translation>
    </message>
    <message>
        <source>Contraction</source>
        <translation>Contraction</translation>
    </message>
    <message>
        <source>Factor on the weight of contraction in the first round.</source>
        <translation>Facteur sur le poids de la contraction à la première passe.</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Croissance</translation>
    </message>
    <message>
        <source>How much stronger each round contracts than the one before.</source>
        <translation>De combien chaque passe contracte plus fort que la précédente.</translation>
    </message>
    <message>
        <source>How often the equations are solved; more of them shorten twigs.</source>
        <translation>Combien de fois les équations sont résolues&#xa0;; davantage raccourcit les brindilles.</translation>
    </message>
    <message>
        <source>Implicit Laplacian</source>
        <translation>Laplacien implicite</translation>
    </message>
    <message>
        <source>Solves for places where the surface has shrunk to lines; bridges holes, is slow.</source>
        <translation>Résout des équations pour les places où la surface s’est réduite à des lignes&#xa0;; franchit les trous, est lent.</translation>
    </message>
    <message>
        <source>scans with holes; clean lines where wood is thick. Shortens twigs; takes memory</source>
        <translation>scans avec des trous&#xa0;; lignes nettes là où le bois est épais. Raccourcit les brindilles&#xa0;; demande de la mémoire</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Échantillons</translation>
    </message>
    <message>
        <source>Share of the points that become samples; the others move with these.</source>
        <translation>Part des points qui deviennent des échantillons&#xa0;; les autres se déplacent avec eux.</translation>
    </message>
    <message>
        <source>First radius</source>
        <translation>Premier rayon</translation>
    </message>
    <message>
        <source>Neighborhoods of the first stage; each stage adds half of it.</source>
        <translation>Voisinages de la première phase&#xa0;; chaque phase en ajoute la moitié.</translation>
    </message>
    <message>
        <source>Last radius</source>
        <translation>Dernier rayon</translation>
    </message>
    <message>
        <source>No stage looks farther than this. More reaches the middle of thicker wood and merges more twigs.</source>
        <translation>Aucune phase ne regarde plus loin que cela. Plus atteint le milieu du bois plus épais et fusionne plus de brindilles.</translation>
    </message>
    <message>
        <source>Rounds per stage</source>
        <translation>Passes par phase</translation>
    </message>
    <message>
        <source>How often samples move in a stage, if they do not rest before.</source>
        <translation>Combien de fois les échantillons bougent dans une phase, s’ils ne s’immobilisent pas avant.</translation>
    </message>
    <message>
        <source>Repulsion</source>
        <translation>Répulsion</translation>
    </message>
    <message>
        <source>How strongly samples push each other apart along the lines they form.</source>
        <translation>Avec quelle force les échantillons se repoussent le long des lignes qu’ils forment.</translation>
    </message>
    <message>
        <source>Least direction</source>
        <translation>Direction minimale</translation>
    </message>
    <message>
        <source>Share of their spread that must lie along a line before samples become a branch and rest.</source>
        <translation>Part de leur étalement qui doit être le long d’une ligne pour que des échantillons deviennent une branche et s’immobilisent.</translation>
    </message>
    <message>
        <source>L1 medial</source>
        <translation>Médian L1</translation>
    </message>
    <message>
        <source>Moves samples to medians of the points about them, while they push each other apart; bears holes, is slow.</source>
        <translation>Déplace des échantillons aux médianes des points autour d’eux, tandis qu’ils se repoussent&#xa0;; supporte les trous, est lent.</translation>
    </message>
    <message>
        <source>scans with holes and strays; slow</source>
        <translation>scans avec des trous et des points isolés&#xa0;; lent</translation>
    </message>
    <message>
        <source>Points of normals</source>
        <translation>Points des normales</translation>
    </message>
    <message>
        <source>How many of the nearest points the normal of each one is found from.</source>
        <translation>Le nombre de points les plus proches dont est tirée la normale de chacun.</translation>
    </message>
    <message>
        <source>How far a section goes across the wood; it need not reach around it.</source>
        <translation>Jusqu’où une section va en travers du bois&#xa0;; elle n’a pas besoin d’en faire le tour.</translation>
    </message>
    <message>
        <source>How often sections and axes are found in turn.</source>
        <translation>Combien de fois les sections et les axes sont trouvés tour à tour.</translation>
    </message>
    <message>
        <source>How often places that normals do not determine follow their neighbors.</source>
        <translation>Combien de fois les places que les normales ne déterminent pas suivent leurs voisines.</translation>
    </message>
    <message>
        <source>Rotational symmetry axes</source>
        <translation>Axes de symétrie de rotation</translation>
    </message>
    <message>
        <source>Moves each point to where the normals of its section meet: the middle of round wood, of which only a part is seen.</source>
        <translation>Déplace chaque point là où les normales de sa section se rencontrent&#xa0;: le milieu du bois rond, dont on ne voit qu’une partie.</translation>
    </message>
    <message>
        <source>clean, dense scans of round wood, from one side, too</source>
        <translation>scans nets et denses de bois rond, même d’un seul côté</translation>
    </message>
    <message>
        <source>How often paths are smoothed.</source>
        <translation>Combien de fois les chemins sont lissés.</translation>
    </message>
    <message>
        <source>Along paths</source>
        <translation>Le long des chemins</translation>
    </message>
    <message>
        <source>Straightens the paths from all points to the root, twigs after the wood that carries them.</source>
        <translation>Redresse les chemins de tous les points vers la racine, les brindilles après le bois qui les porte.</translation>
    </message>
    <message>
        <source>smooth twigs of noisy scans; leaves thick wood nearly as it is</source>
        <translation>brindilles lisses de scans bruités&#xa0;; laisse le bois épais presque tel quel</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Bruit</translation>
    </message>
    <message>
        <source>Points this near are of it, too, where the scan scatters wide.</source>
        <translation>Les points à cette distance en font aussi partie, là où le scan est très dispersé.</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Maille</translation>
    </message>
    <message>
        <source>Between the particles of the cloth; smaller ones follow rougher ground.</source>
        <translation>Entre les particules du tissu&#xa0;; une plus petite suit un sol plus accidenté.</translation>
    </message>
    <message>
        <source>Points up to this above the cloth are of the ground.</source>
        <translation>Les points jusqu’à cette hauteur au-dessus du tissu sont du sol.</translation>
    </message>
    <message>
        <source>Rigidness</source>
        <translation>Rigidité</translation>
    </message>
    <message>
        <source>1 follows steep ground, 3 spans wide gaps below crowns.</source>
        <translation>1 suit un sol pentu, 3 franchit de larges lacunes sous les houppiers.</translation>
    </message>
    <message>
        <source>Steps that the cloth falls at most.</source>
        <translation>Nombre maximal de pas dont le tissu tombe.</translation>
    </message>
    <message>
        <source>Follow slopes</source>
        <translation>Suivre les pentes</translation>
    </message>
    <message>
        <source>Pulls the cloth onto ground near it where it is steep.</source>
        <translation>Tire le tissu sur le sol proche de lui là où la pente est forte.</translation>
    </message>
    <message>
        <source>Cloth</source>
        <translation>Tissu</translation>
    </message>
    <message>
        <source>Lays a cloth on the scan from below and leaves out what it touches.</source>
        <translation>Pose un tissu sur le scan par en dessous et écarte ce qu’il touche.</translation>
    </message>
    <message>
        <source>Points this near to the wall of a pole are of it.</source>
        <translation>Les points à cette distance de la paroi d’un poteau en font partie.</translation>
    </message>
    <message>
        <source>Largest radius</source>
        <translation>Rayon maximal</translation>
    </message>
    <message>
        <source>Thicker cylinders are no poles.</source>
        <translation>Les cylindres plus épais ne sont pas des poteaux.</translation>
    </message>
    <message>
        <source>Shorter cylinders are no poles.</source>
        <translation>Les cylindres plus courts ne sont pas des poteaux.</translation>
    </message>
    <message>
        <source>How far around its middle a cylinder is sought.</source>
        <translation>Jusqu’où autour de son milieu un cylindre est cherché.</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Lacune</translation>
    </message>
    <message>
        <source>A pole goes on over gaps up to this.</source>
        <translation>Un poteau continue par-dessus des lacunes allant jusque-là.</translation>
    </message>
    <message>
        <source>Largest lean</source>
        <translation>Inclinaison maximale</translation>
    </message>
    <message>
        <source>Cylinders that lean more are no poles.</source>
        <translation>Les cylindres plus inclinés ne sont pas des poteaux.</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>Cylinders that are tried at each place.</source>
        <translation>Cylindres qui sont essayés à chaque endroit.</translation>
    </message>
    <message>
        <source>Cylinders</source>
        <translation>Cylindres</translation>
    </message>
    <message>
        <source>Leaves out straight cylinders that stand by themselves, are as thick above as below, and end free.</source>
        <translation>Écarte les cylindres droits qui se tiennent seuls, sont aussi épais en haut qu’en bas, et finissent librement.</translation>
    </message>
    <message>
        <source>Points this near to the curve of a wire are of it.</source>
        <translation>Les points à cette distance de la courbe d’un câble en font partie.</translation>
    </message>
    <message>
        <source>Shorter curves are no wires.</source>
        <translation>Les courbes plus courtes ne sont pas des câbles.</translation>
    </message>
    <message>
        <source>A wire goes on over gaps up to this.</source>
        <translation>Un câble continue par-dessus des lacunes allant jusque-là.</translation>
    </message>
    <message>
        <source>Largest sag</source>
        <translation>Flèche maximale</translation>
    </message>
    <message>
        <source>How deep a wire may hang, by its span.</source>
        <translation>De combien un câble peut pendre, par rapport à la distance entre ses extrémités.</translation>
    </message>
    <message>
        <source>Hanging curves</source>
        <translation>Courbes suspendues</translation>
    </message>
    <message>
        <source>Leaves out thin curves that hang free between two ends.</source>
        <translation>Écarte les courbes minces qui pendent librement entre deux extrémités.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Which plant stays, by size: 1 is the largest; 0 is the one at the root that was chosen, without one the largest.</source>
        <translation>Quelle plante reste, par taille&#xa0;: 1 est la plus grande&#xa0;; 0 est celle de la racine choisie, sans racine choisie la plus grande.</translation>
    </message>
    <message>
        <source>Stems from</source>
        <translation>Tiges à partir de</translation>
    </message>
    <message>
        <source>Stems are looked for from this height above the ground on.</source>
        <translation>Les tiges sont cherchées à partir de cette hauteur au-dessus du sol.</translation>
    </message>
    <message>
        <source>Stems to</source>
        <translation>Tiges jusqu’à</translation>
    </message>
    <message>
        <source>Stems are looked for up to this height above the ground.</source>
        <translation>Les tiges sont cherchées jusqu’à cette hauteur au-dessus du sol.</translation>
    </message>
    <message>
        <source>Least stem</source>
        <translation>Tige minimale</translation>
    </message>
    <message>
        <source>What crosses these heights with fewer places than this share of the thickest stem is a twig.</source>
        <translation>Ce qui traverse ces hauteurs avec moins d’endroits que cette part de la tige la plus épaisse est une brindille.</translation>
    </message>
    <message>
        <source>Together</source>
        <translation>Ensemble</translation>
    </message>
    <message>
        <source>Stems nearer to each other than this are of one plant.</source>
        <translation>Les tiges plus proches l’une de l’autre que cela sont d’une même plante.</translation>
    </message>
    <message>
        <source>One wood</source>
        <translation>Un seul bois</translation>
    </message>
    <message>
        <source>Where wood leads from one stem to another and is nowhere thinner than this share of the thinner stem, both are one plant.</source>
        <translation>Là où du bois mène d’une tige à une autre et n’est nulle part plus mince que cette part de la tige la plus mince, les deux sont une même plante.</translation>
    </message>
    <message>
        <source>Parts farther off than this from all plants are of none.</source>
        <translation>Les parties plus loin que cela de toutes les plantes ne sont d’aucune.</translation>
    </message>
    <message>
        <source>Cube</source>
        <translation>Cube</translation>
    </message>
    <message>
        <source>Paths lead over the means of cubes of this size.</source>
        <translation>Les chemins passent par les moyennes de cubes de cette taille.</translation>
    </message>
    <message>
        <source>A link counts as its length to this: more shuns gaps.</source>
        <translation>Une liaison compte comme sa longueur à cette puissance&#xa0;: plus évite les lacunes.</translation>
    </message>
    <message>
        <source>Thinness</source>
        <translation>Minceur</translation>
    </message>
    <message>
        <source>A link counts by how thin the wood is there to this: more keeps branches with their own plant where twigs of others touch them.</source>
        <translation>Une liaison compte selon la minceur du bois à cet endroit, à cette puissance&#xa0;: plus garde les branches à leur propre plante là où les brindilles d’autres les touchent.</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Virage</translation>
    </message>
    <message>
        <source>How much a link counts more where a path turns back: 0 takes turns as they come.</source>
        <translation>De combien une liaison compte plus là où un chemin revient en arrière&#xa0;: 0 prend les virages comme ils viennent.</translation>
    </message>
    <message>
        <source>Plants with less of the points of the largest are none.</source>
        <translation>Les plantes ayant moins que cette part des points de la plus grande n’en sont pas.</translation>
    </message>
    <message>
        <source>Nearest stem</source>
        <translation>Tige la plus proche</translation>
    </message>
    <message>
        <source>Keeps one plant: what is nearer to its stem, along the plants, than to those of others.</source>
        <translation>Garde une plante&#xa0;: ce qui est plus près de sa tige, le long des plantes, que de celles des autres.</translation>
    </message>
    <message>
        <source>Keeps the ground.</source>
        <translation>Garde le sol.</translation>
    </message>
    <message>
        <source>Keeps poles.</source>
        <translation>Garde les poteaux.</translation>
    </message>
    <message>
        <source>Keeps wires.</source>
        <translation>Garde les câbles.</translation>
    </message>
    <message>
        <source>Takes all points for one plant.</source>
        <translation>Prend tous les points pour une seule plante.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Another seed draws other points.</source>
        <translation>Une autre graine tire d’autres points.</translation>
    </message>
    <message>
        <source>How many of the points stay.</source>
        <translation>Combien de points restent.</translation>
    </message>
    <message>
        <source>By chance</source>
        <translation>Au hasard</translation>
    </message>
    <message>
        <source>Keeps a share of the points, drawn by chance.</source>
        <translation>Garde une part des points, tirés au hasard.</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Arête</translation>
    </message>
    <message>
        <source>Of the cubes, of each of which one point stays.</source>
        <translation>Des cubes, dont chacun garde un point.</translation>
    </message>
    <message>
        <source>One per cube</source>
        <translation>Un par cube</translation>
    </message>
    <message>
        <source>Keeps one point of each cube of an even grid: the one nearest to their mean.</source>
        <translation>Garde un point de chaque cube d’une grille régulière&#xa0;: le plus proche de leur moyenne.</translation>
    </message>
    <message>
        <source>No two points that stay are nearer to each other than this.</source>
        <translation>Deux points qui restent ne sont jamais plus proches l’un de l’autre que cela.</translation>
    </message>
    <message>
        <source>Least spacing</source>
        <translation>Espacement minimal</translation>
    </message>
    <message>
        <source>Keeps points that are not too near to each other, as evenly as they lie.</source>
        <translation>Garde des points qui ne sont pas trop proches entre eux, aussi régulièrement qu’ils sont placés.</translation>
    </message>
    <message>
        <source>Keeps as many points as there are.</source>
        <translation>Garde autant de points qu’il y en a.</translation>
    </message>
    <message>
        <source>windows, pictures in 2D, reports</source>
        <translation>fenêtres, images en 2D, rapports</translation>
    </message>
    <message>
        <source>pictures in 3D</source>
        <translation>images en 3D</translation>
    </message>
    <message>
        <source>functions of OpenGL</source>
        <translation>fonctions d’OpenGL</translation>
    </message>
    <message>
        <source>vectors and matrices</source>
        <translation>vecteurs et matrices</translation>
    </message>
    <message>
        <source>neighbors of points</source>
        <translation>voisins des points</translation>
    </message>
    <message>
        <source>work on all processors</source>
        <translation>travail sur tous les processeurs</translation>
    </message>
    <message>
        <source>convex hulls</source>
        <translation>enveloppes convexes</translation>
    </message>
    <message>
        <source>project files</source>
        <translation>fichiers de projet</translation>
    </message>
    <message>
        <source>whether a file is the same</source>
        <translation>si un fichier est le même</translation>
    </message>
    <message>
        <source>files in XML</source>
        <translation>fichiers XML</translation>
    </message>
    <message>
        <source>files in JSON</source>
        <translation>fichiers JSON</translation>
    </message>
    <message>
        <source>MAT files</source>
        <translation>fichiers MAT</translation>
    </message>
    <message>
        <source>PCD files</source>
        <translation>fichiers PCD</translation>
    </message>
    <message>
        <source>the command line</source>
        <translation>la ligne de commande</translation>
    </message>
    <message>
        <source>Registering</source>
        <translation>Recalage</translation>
    </message>
    <message>
        <source>Counting edits</source>
        <translation>Comptage des modifications</translation>
    </message>
    <message>
        <source>Measuring distances</source>
        <translation>Mesure des distances</translation>
    </message>
    <message>
        <source>Measuring light</source>
        <translation>Mesure de la lumière</translation>
    </message>
    <message>
        <source>Finding differences</source>
        <translation>Recherche des différences</translation>
    </message>
    <message>
        <source>Comparing</source>
        <translation>Comparaison</translation>
    </message>
    <message>
        <source>Comparing segments</source>
        <translation>Comparaison des segments</translation>
    </message>
    <message>
        <source>Matching segments</source>
        <translation>Appariement des segments</translation>
    </message>
    <message>
        <source>RMS, 0–25 % seen</source>
        <translation>RMS, 0–25&#xa0;% vus</translation>
    </message>
    <message>
        <source>RMS, 25–50 % seen</source>
        <translation>RMS, 25–50&#xa0;% vus</translation>
    </message>
    <message>
        <source>RMS, 50–75 % seen</source>
        <translation>RMS, 50–75&#xa0;% vus</translation>
    </message>
    <message>
        <source>RMS, 75–100 % seen</source>
        <translation>RMS, 75–100&#xa0;% vus</translation>
    </message>
    <message>
        <source>Comparing plants</source>
        <translation>Comparaison des plantes</translation>
    </message>
    <message>
        <source>Comparing results</source>
        <translation>Comparaison des résultats</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Tirage</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Nodes of the skeleton</source>
        <translation>Nœuds du squelette</translation>
    </message>
    <message>
        <source>trees</source>
        <translation>arbres</translation>
    </message>
    <message>
        <source>Roots: parts that are not connected</source>
        <translation>Racines&#xa0;: parties qui ne sont pas reliées</translation>
    </message>
    <message>
        <source>segments</source>
        <translation>segments</translation>
    </message>
    <message>
        <source>Stretches between branchings, roots and tips</source>
        <translation>Tronçons entre ramifications, racines et extrémités</translation>
    </message>
    <message>
        <source>tips</source>
        <translation>extrémités</translation>
    </message>
    <message>
        <source>Nodes without a child</source>
        <translation>Nœuds sans enfant</translation>
    </message>
    <message>
        <source>branchings</source>
        <translation>ramifications</translation>
    </message>
    <message>
        <source>Nodes with several children</source>
        <translation>Nœuds à plusieurs enfants</translation>
    </message>
    <message>
        <source>orders</source>
        <translation>ordres</translation>
    </message>
    <message>
        <source>How many orders of axes there are, the trunk included</source>
        <translation>Combien il y a d’ordres d’axes, tronc compris</translation>
    </message>
    <message>
        <source>Strahler number</source>
        <translation>Nombre de Strahler</translation>
    </message>
    <message>
        <source>A tip has 1; a node the greatest above it, and one more where several have that</source>
        <translation>Une extrémité a 1&#xa0;; un nœud, le plus grand au-dessus de lui, et un de plus là où plusieurs l’ont</translation>
    </message>
    <message>
        <source>length</source>
        <translation>longueur</translation>
    </message>
    <message>
        <source>Of all edges</source>
        <translation>De toutes les arêtes</translation>
    </message>
    <message>
        <source>median edge</source>
        <translation>arête médiane</translation>
    </message>
    <message>
        <source>Between a node and its parent</source>
        <translation>Entre un nœud et son parent</translation>
    </message>
    <message>
        <source>Stem</source>
        <translation>Tige</translation>
    </message>
    <message>
        <source>stem length</source>
        <translation>longueur de la tige</translation>
    </message>
    <message>
        <source>Along the axis that begins at the root</source>
        <translation>Le long de l’axe qui commence à la racine</translation>
    </message>
    <message>
        <source>lowest branch on it</source>
        <translation>sa branche la plus basse</translation>
    </message>
    <message>
        <source>Along the stem</source>
        <translation>Le long de la tige</translation>
    </message>
    <message>
        <source>highest branch on it</source>
        <translation>sa branche la plus haute</translation>
    </message>
    <message>
        <source>stem radius at the base</source>
        <translation>rayon de la tige à la base</translation>
    </message>
    <message>
        <source>Of its first node with a radius</source>
        <translation>De son premier nœud qui a un rayon</translation>
    </message>
    <message>
        <source>stem radius at the top</source>
        <translation>rayon de la tige au sommet</translation>
    </message>
    <message>
        <source>Of its last node</source>
        <translation>De son dernier nœud</translation>
    </message>
    <message>
        <source>Crown</source>
        <translation>Houppier</translation>
    </message>
    <message>
        <source>height</source>
        <translation>hauteur</translation>
    </message>
    <message>
        <source>From the lowest node to the highest</source>
        <translation>Du nœud le plus bas au plus haut</translation>
    </message>
    <message>
        <source>crown base</source>
        <translation>base du houppier</translation>
    </message>
    <message>
        <source>Height above the lowest node of where the lowest branch leaves</source>
        <translation>Hauteur, au-dessus du nœud le plus bas, du départ de la branche la plus basse</translation>
    </message>
    <message>
        <source>crown depth</source>
        <translation>profondeur du houppier</translation>
    </message>
    <message>
        <source>From there to the highest node</source>
        <translation>De là au nœud le plus haut</translation>
    </message>
    <message>
        <source>crown area</source>
        <translation>surface du houppier</translation>
    </message>
    <message>
        <source>Of the convex hull of the branches, seen from above</source>
        <translation>De l’enveloppe convexe des branches, vue d’en haut</translation>
    </message>
    <message>
        <source>crown diameter</source>
        <translation>diamètre du houppier</translation>
    </message>
    <message>
        <source>Of a circle of that area</source>
        <translation>D’un cercle de cette surface</translation>
    </message>
    <message>
        <source>crown spread</source>
        <translation>étendue du houppier</translation>
    </message>
    <message>
        <source>Greatest horizontal distance between two nodes of branches</source>
        <translation>Plus grande distance horizontale entre deux nœuds de branches</translation>
    </message>
    <message>
        <source>Angles by order</source>
        <translation>Angles par ordre</translation>
    </message>
    <message>
        <source>Mean, between branches of this order and what bears them</source>
        <translation>Moyenne, entre les branches de cet ordre et ce qui les porte</translation>
    </message>
    <message>
        <source>Branching</source>
        <translation>Ramification</translation>
    </message>
    <message>
        <source>divergence</source>
        <translation>divergence</translation>
    </message>
    <message>
        <source>Mean, around the axis from one branch to the next</source>
        <translation>Moyenne, autour de l’axe, d’une branche à la suivante</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>Bois</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>volume</translation>
    </message>
    <message>
        <source>Edges count as truncated cones</source>
        <translation>Les arêtes comptent comme des troncs de cône</translation>
    </message>
    <message>
        <source>volume, at least</source>
        <translation>volume, au moins</translation>
    </message>
    <message>
        <source>With a probability of 95 %, as far as the radii err; missing wood does not count</source>
        <translation>Avec une probabilité de 95&#xa0;%, pour l’erreur des rayons&#xa0;; le bois qui manque ne compte pas</translation>
    </message>
    <message>
        <source>volume, at most</source>
        <translation>volume, au plus</translation>
    </message>
    <message>
        <source>bark area</source>
        <translation>surface de l’écorce</translation>
    </message>
    <message>
        <source>Of the same</source>
        <translation>De ces mêmes troncs de cône</translation>
    </message>
    <message>
        <source>Of the stem, at breast height above the foot</source>
        <translation>De la tige, à hauteur de poitrine au-dessus du pied</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Lumière</translation>
    </message>
    <message>
        <source>STAR</source>
        <translation>STAR</translation>
    </message>
    <message>
        <source>Silhouette to total area, over an overcast sky; 0.25 of a sphere</source>
        <translation>Silhouette rapportée à la surface totale, pour un ciel couvert&#xa0;; 0.25 pour une sphère</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>surface</translation>
    </message>
    <message>
        <source>Of the wood that light falls on</source>
        <translation>Du bois que la lumière atteint</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Remplissage des trous</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <source>Where the thin wood is at most so many point spacings thick, all points are kept.</source>
        <translation>Là où l’épaisseur du bois mince ne dépasse pas ce nombre d’espacements des points, tous les points sont gardés.</translation>
    </message>
    <message>
        <source>As needed</source>
        <translation>Selon le besoin</translation>
    </message>
    <message>
        <source>branching angle, order %1</source>
        <translation>angle de ramification, ordre %1</translation>
    </message>
    <message>
        <source>radius ahead</source>
        <translation>rayon devant</translation>
    </message>
    <message>
        <source>radius left</source>
        <translation>rayon à gauche</translation>
    </message>
    <message>
        <source>radius behind</source>
        <translation>rayon derrière</translation>
    </message>
    <message>
        <source>radius right</source>
        <translation>rayon à droite</translation>
    </message>
    <message>
        <source>height ahead</source>
        <translation>hauteur devant</translation>
    </message>
    <message>
        <source>height left</source>
        <translation>hauteur à gauche</translation>
    </message>
    <message>
        <source>height behind</source>
        <translation>hauteur derrière</translation>
    </message>
    <message>
        <source>height right</source>
        <translation>hauteur à droite</translation>
    </message>
    <message>
        <source>azimuth of ahead</source>
        <translation>azimut de l’avant</translation>
    </message>
    <message>
        <source>exponent above</source>
        <translation>exposant en haut</translation>
    </message>
    <message>
        <source>exponent below</source>
        <translation>exposant en bas</translation>
    </message>
    <message>
        <source>share of the points inside</source>
        <translation>part des points à l’intérieur</translation>
    </message>
    <message>
        <source>width</source>
        <translation>largeur</translation>
    </message>
    <message>
        <source>azimuth</source>
        <translation>azimut</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>rayon</translation>
    </message>
    <message>
        <source>semi-axis a</source>
        <translation>demi-axe a</translation>
    </message>
    <message>
        <source>semi-axis b</source>
        <translation>demi-axe b</translation>
    </message>
    <message>
        <source>semi-axis c</source>
        <translation>demi-axe c</translation>
    </message>
    <message>
        <source>lean</source>
        <translation>inclinaison</translation>
    </message>
    <message>
        <source>ahead</source>
        <translation>devant</translation>
    </message>
    <message>
        <source>left</source>
        <translation>gauche</translation>
    </message>
    <message>
        <source>behind</source>
        <translation>derrière</translation>
    </message>
    <message>
        <source>right</source>
        <translation>droite</translation>
    </message>
    <message>
        <source>top</source>
        <translation>sommet</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>base</translation>
    </message>
    <message>
        <source>ahead, low</source>
        <translation>devant, bas</translation>
    </message>
    <message>
        <source>ahead, in the middle</source>
        <translation>devant, au milieu</translation>
    </message>
    <message>
        <source>ahead, high</source>
        <translation>devant, haut</translation>
    </message>
    <message>
        <source>behind, low</source>
        <translation>derrière, bas</translation>
    </message>
    <message>
        <source>behind, in the middle</source>
        <translation>derrière, au milieu</translation>
    </message>
    <message>
        <source>behind, high</source>
        <translation>derrière, haut</translation>
    </message>
    <message>
        <source>outline, ahead to the left</source>
        <translation>contour, devant à gauche</translation>
    </message>
    <message>
        <source>outline, left</source>
        <translation>contour, gauche</translation>
    </message>
    <message>
        <source>outline, behind to the left</source>
        <translation>contour, derrière à gauche</translation>
    </message>
    <message>
        <source>outline, behind to the right</source>
        <translation>contour, derrière à droite</translation>
    </message>
    <message>
        <source>outline, right</source>
        <translation>contour, droite</translation>
    </message>
    <message>
        <source>outline, ahead to the right</source>
        <translation>contour, devant à droite</translation>
    </message>
    <message>
        <source>azimuth of the side profile</source>
        <translation>azimut du profil de côté</translation>
    </message>
    <message>
        <source>outline ahead of its middle</source>
        <translation>contour devant son milieu</translation>
    </message>
    <message>
        <source>outline behind its middle</source>
        <translation>contour derrière son milieu</translation>
    </message>
    <message>
        <source>corners of the outline</source>
        <translation>sommets du contour</translation>
    </message>
    <message>
        <source>corners of the side profile</source>
        <translation>sommets du profil de côté</translation>
    </message>
    <message>
        <source>bottom radius</source>
        <translation>rayon de la base</translation>
    </message>
    <message>
        <source>top radius</source>
        <translation>rayon du sommet</translation>
    </message>
    <message>
        <source>center</source>
        <translation>centre</translation>
    </message>
    <message>
        <source>side %1, low</source>
        <translation>côté %1, bas</translation>
    </message>
    <message>
        <source>side %1, middle</source>
        <translation>côté %1, milieu</translation>
    </message>
    <message>
        <source>side %1, high</source>
        <translation>côté %1, haut</translation>
    </message>
    <message>
        <source>profiles</source>
        <translation>profils</translation>
    </message>
    <message>
        <source>azimuth of the first profile</source>
        <translation>azimut du premier profil</translation>
    </message>
    <message>
        <source>radius of the ball</source>
        <translation>rayon de la boule</translation>
    </message>
    <message>
        <source>pieces</source>
        <translation>morceaux</translation>
    </message>
    <message>
        <source>points</source>
        <translation>points</translation>
    </message>
    <message>
        <source>side of the cubes</source>
        <translation>côté des cubes</translation>
    </message>
    <message>
        <source>Simulated scan</source>
        <translation>Scan simulé</translation>
    </message>
    <message>
        <source>a scan of under 20 points cannot be registered: check that it is the right one</source>
        <translation>un scan de moins de 20 points ne peut pas être recalé&#xa0;: vérifiez que c’est le bon</translation>
    </message>
    <message>
        <source>the scans do not overlap where they lie: give three pairs of targets, or more reach</source>
        <translation>les scans ne se recouvrent pas là où ils se trouvent&#xa0;: indiquez trois paires de cibles, ou une portée plus grande</translation>
    </message>
    <message>
        <source>the points of a scan all lie at one place: check that it is the right one</source>
        <translation>tous les points d’un scan sont au même endroit&#xa0;: vérifiez que c’est le bon</translation>
    </message>
    <message>
        <source>1 pair of targets leave open how the scan lies: pick three or more</source>
        <translation>1 paire de cibles ne suffit pas à placer le scan&#xa0;: pointez-en trois ou plus</translation>
    </message>
    <message>
        <source>%1 pairs of targets leave open how the scan lies: pick three or more</source>
        <translation>%1 paires de cibles ne suffisent pas à placer le scan&#xa0;: pointez-en trois ou plus</translation>
    </message>
    <message>
        <source>pair %1: a coordinate is no number, or beyond 1e12: correct or remove it</source>
        <translation>paire&#xa0;%1&#xa0;: une coordonnée n’est pas un nombre, ou dépasse 1e12&#xa0;: corrigez-la ou retirez-la</translation>
    </message>
    <message>
        <source>the targets of the moved scan lie at one place: pick them far apart</source>
        <translation>les cibles du scan déplacé sont au même endroit&#xa0;: pointez-les loin les unes des autres</translation>
    </message>
    <message>
        <source>the targets of the moved scan lie on a line, about which it could turn: pick another beside it</source>
        <translation>les cibles du scan déplacé sont sur une droite, autour de laquelle il pourrait tourner&#xa0;: pointez-en une autre à côté</translation>
    </message>
    <message>
        <source>the targets of the fixed scan lie at one place: pick them far apart</source>
        <translation>les cibles du scan fixe sont au même endroit&#xa0;: pointez-les loin les unes des autres</translation>
    </message>
    <message>
        <source>the targets of the fixed scan lie on a line, about which it could turn: pick another beside it</source>
        <translation>les cibles du scan fixe sont sur une droite, autour de laquelle il pourrait tourner&#xa0;: pointez-en une autre à côté</translation>
    </message>
    <message>
        <source>the targets of one scan are over twice as far apart as those of the other: check the pairs, and that both scans are in one unit</source>
        <translation>les cibles d’un scan sont plus de deux fois plus éloignées que celles de l’autre&#xa0;: vérifiez les paires, et que les deux scans sont dans la même unité</translation>
    </message>
    <message>
        <source>this part has been edited since it was compared: wait until it is compared again</source>
        <translation>cette partie a été modifiée depuis la comparaison&#xa0;: attendez qu’elle soit de nouveau comparée</translation>
    </message>
    <message>
        <source>what is attached here is of the reference: accept what was missed beside it, or attach it elsewhere</source>
        <translation>ce qui est attaché ici est de la référence&#xa0;: acceptez ce qui a été manqué à côté, ou rattachez-le ailleurs</translation>
    </message>
    <message>
        <source>without this the plant would fall into several trees: attach elsewhere what it carries, or add what was missed below first</source>
        <translation>sans cela, la plante se séparerait en plusieurs arbres&#xa0;: rattachez ailleurs ce qu’il porte, ou ajoutez d’abord ce qui a été manqué en dessous</translation>
    </message>
    <message>
        <source>what should bear this is attached to it now: accept that part first</source>
        <translation>ce qui devrait porter cette partie lui est attaché pour l’instant&#xa0;: acceptez d’abord cette partie-là</translation>
    </message>
    <message>
        <source>nothing of scale %1 begins at node %2: choose the node it begins at</source>
        <translation>rien d’échelle&#xa0;%1 ne commence au nœud&#xa0;%2&#xa0;: choisissez le nœud où cela commence</translation>
    </message>
    <message>
        <source>the plant has a feature %1 already: type its value there, or choose another name</source>
        <translation>la plante a déjà un attribut&#xa0;%1&#xa0;: saisissez-y sa valeur, ou choisissez un autre nom</translation>
    </message>
    <message>
        <source>%1 is no type of a feature: choose one of the list</source>
        <translation>%1 n’est pas un type d’attribut&#xa0;: choisissez-en un dans la liste</translation>
    </message>
    <message>
        <source>the feature %1 has no value yet: type one</source>
        <translation>l’attribut&#xa0;%1 n’a pas encore de valeur&#xa0;: saisissez-en une</translation>
    </message>
    <message>
        <source>%1 is of type %2: %3 is not a number, such as %4</source>
        <translation>%1 est de type&#xa0;%2&#xa0;: %3 n’est pas un nombre, comme&#xa0;%4</translation>
    </message>
    <message>
        <source>%1 is of type %2: %3 is not a whole number, such as %4</source>
        <translation>%1 est de type&#xa0;%2&#xa0;: %3 n’est pas un nombre entier, comme&#xa0;%4</translation>
    </message>
    <message>
        <source>%1 is of type %2: %3 is not a date, such as %4</source>
        <translation>%1 est de type&#xa0;%2&#xa0;: %3 n’est pas une date, comme&#xa0;%4</translation>
    </message>
    <message>
        <source>%1 cannot stand in an MTG: take out tabs, line ends and comment signs (# and ;)</source>
        <translation>%1 ne peut pas figurer dans un MTG&#xa0;: retirez les tabulations, les fins de ligne et les signes de commentaire (# et&#xa0;;)</translation>
    </message>
    <message>
        <source>%1 is no name of a feature: type letters, digits and _, such as Length or leaf_area</source>
        <translation>%1 n’est pas un nom d’attribut&#xa0;: saisissez des lettres, des chiffres et _, comme Length ou leaf_area</translation>
    </message>
    <message>
        <source>%1 stands for the position, radius or alias, which have fields of their own: choose another name</source>
        <translation>%1 désigne la position, le rayon ou l’alias, qui ont leurs propres champs&#xa0;: choisissez un autre nom</translation>
    </message>
    <message>
        <source>%1 is no alias: type letters, digits, and _ - . between them, or nothing</source>
        <translation>%1 n’est pas un alias&#xa0;: saisissez des lettres, des chiffres et, entre eux, _ - ., ou rien</translation>
    </message>
    <message>
        <source>%1 is no symbol of a class: type letters alone, such as S or GU</source>
        <translation>%1 n’est pas le symbole d’une classe&#xa0;: saisissez seulement des lettres, comme S ou GU</translation>
    </message>
    <message>
        <source>%1 begins at node %2 already: choose a node further on</source>
        <translation>%1 commence déjà au nœud&#xa0;%2&#xa0;: choisissez un nœud plus loin</translation>
    </message>
    <message>
        <source>no unit of scale %1 begins at node %2: choose the node it begins at</source>
        <translation>aucune unité d’échelle&#xa0;%1 ne commence au nœud&#xa0;%2&#xa0;: choisissez le nœud où elle commence</translation>
    </message>
    <message>
        <source>node %1 is a root, where its units begin: choose a node above it</source>
        <translation>le nœud&#xa0;%1 est une racine, où commencent ses unités&#xa0;: choisissez un nœud plus haut</translation>
    </message>
    <message>
        <source>%1 begins at node %2 too, and units do not reach beyond it: join that one first</source>
        <translation>%1 commence aussi au nœud&#xa0;%2, et des unités ne s’étendent pas au-delà&#xa0;: joignez d’abord celle-là</translation>
    </message>
    <message>
        <source>the class %1 is of scale %2, this is of scale %3: choose another symbol</source>
        <translation>la classe&#xa0;%1 est d’échelle&#xa0;%2, celle-ci est d’échelle&#xa0;%3&#xa0;: choisissez un autre symbole</translation>
    </message>
    <message>
        <source>%1 is no index: type a whole number, such as 3, two parted by a dot, such as 16.1, or nothing</source>
        <translation>%1 n’est pas un indice&#xa0;: saisissez un nombre entier, comme 3, deux séparés par un point, comme 16.1, ou rien</translation>
    </message>
    <message>
        <source>%1 is the alias of %2 at node %3 already: choose another one</source>
        <translation>%1 est déjà l’alias de&#xa0;%2 au nœud&#xa0;%3&#xa0;: choisissez-en un autre</translation>
    </message>
    <message>
        <source>the plant has a class %1 already: choose another symbol</source>
        <translation>la plante a déjà une classe&#xa0;%1&#xa0;: choisissez un autre symbole</translation>
    </message>
    <message>
        <source>no node is marked: mark first where units begin</source>
        <translation>aucun nœud n’est marqué&#xa0;: marquez d’abord où commencent les unités</translation>
    </message>
    <message>
        <source>the plant has %1 scales: there can be no more</source>
        <translation>la plante a&#xa0;%1 échelles&#xa0;: il ne peut pas y en avoir davantage</translation>
    </message>
    <message>
        <source>there is a version %1 already: choose another name</source>
        <translation>il y a déjà une version&#xa0;%1&#xa0;: choisissez un autre nom</translation>
    </message>
    <message>
        <source>the seal has no hash that can be read: sign the structure again</source>
        <translation>l’empreinte du sceau est illisible&#xa0;: signez de nouveau la structure</translation>
    </message>
    <message>
        <source>a seal needs a name: type who signs</source>
        <translation>un sceau demande un nom&#xa0;: saisissez qui signe</translation>
    </message>
    <message>
        <source>there is no skeleton to sign: make one first</source>
        <translation>il n’y a pas de squelette à signer&#xa0;: faites-en un d’abord</translation>
    </message>
    <message>
        <source>%1 of %2 nodes are not reviewed: walk there and review them first</source>
        <translation>%1 nœuds sur&#xa0;%2 ne sont pas révisés&#xa0;: allez-y et révisez-les d’abord</translation>
    </message>
    <message>
        <source>the seal of this structure cannot be read: sign it again</source>
        <translation>le sceau de cette structure est illisible&#xa0;: signez-la de nouveau</translation>
    </message>
    <message>
        <source>the seal of this structure is not complete: sign it again</source>
        <translation>le sceau de cette structure n’est pas complet&#xa0;: signez-la de nouveau</translation>
    </message>
    <message>
        <source>node %1 has no radius yet: measure it, or type one in the inspector</source>
        <translation>le nœud&#xa0;%1 n’a pas encore de rayon&#xa0;: mesurez-le, ou saisissez-en un dans l’inspecteur</translation>
    </message>
    <message>
        <source>node %1 carries nothing: choose a node farther from the tips</source>
        <translation>le nœud&#xa0;%1 ne porte rien&#xa0;: choisissez un nœud plus loin des extrémités</translation>
    </message>
    <message>
        <source>node %1 is a root, attached to nothing: choose a node above it</source>
        <translation>le nœud&#xa0;%1 est une racine, attachée à rien&#xa0;: choisissez un nœud plus haut</translation>
    </message>
    <message>
        <source>node %1 and node %2 are attached to the same node: there is nothing to exchange</source>
        <translation>les nœuds&#xa0;%1 et&#xa0;%2 sont attachés au même nœud&#xa0;: il n’y a rien à échanger</translation>
    </message>
    <message>
        <source>of node %1 and node %2 one carries the other: choose arms of two branches that cross</source>
        <translation>l’un des nœuds&#xa0;%1 et&#xa0;%2 porte l’autre&#xa0;: choisissez des bras de deux branches qui se croisent</translation>
    </message>
    <message>
        <source>node %1 is a root and has no edge to a parent: choose a node above it</source>
        <translation>le nœud&#xa0;%1 est une racine et n’a pas d’arête vers un parent&#xa0;: choisissez un nœud plus haut</translation>
    </message>
    <message>
        <source>node %1 is the root of a separate piece of 1 node</source>
        <translation>le nœud&#xa0;%1 est la racine d’un morceau séparé d’un nœud</translation>
    </message>
    <message>
        <source>node %1 is the root of a separate piece of %2 nodes</source>
        <translation>le nœud&#xa0;%1 est la racine d’un morceau séparé de&#xa0;%2 nœuds</translation>
    </message>
    <message>
        <source>node %1 has %2 successors: an axis continues once</source>
        <translation>le nœud&#xa0;%1 a&#xa0;%2 successeurs&#xa0;: un axe ne continue qu’une fois</translation>
    </message>
    <message>
        <source>an axis begins at node %1, though nothing else goes on from node %2</source>
        <translation>un axe commence au nœud&#xa0;%1, alors que rien d’autre ne continue depuis le nœud&#xa0;%2</translation>
    </message>
    <message>
        <source>node %1 lies on its parent: the edge has no length</source>
        <translation>le nœud&#xa0;%1 est sur son parent&#xa0;: l’arête est de longueur nulle</translation>
    </message>
    <message>
        <source>the edge to node %1 lies on the one to node %2</source>
        <translation>l’arête vers le nœud&#xa0;%1 est sur celle vers le nœud&#xa0;%2</translation>
    </message>
    <message>
        <source>the branch that begins at node %1 turns back by %2°</source>
        <translation>la branche qui commence au nœud&#xa0;%1 revient en arrière de&#xa0;%2°</translation>
    </message>
    <message>
        <source>the axis turns by %2° at node %1</source>
        <translation>l’axe tourne de&#xa0;%2° au nœud&#xa0;%1</translation>
    </message>
    <message>
        <source>node %1 and node %2 touch, but are not of one branch: %3 apart</source>
        <translation>les nœuds&#xa0;%1 et&#xa0;%2 se touchent, mais ne sont pas d’une même branche&#xa0;:&#xa0;%3 d’écart</translation>
    </message>
    <message>
        <source>the axis that ends at node %1 comes back onto the wood at node %2</source>
        <translation>l’axe qui finit au nœud&#xa0;%1 revient sur le bois au nœud&#xa0;%2</translation>
    </message>
    <message>
        <source>node %1 is thicker than its parent: radius %2 on %3</source>
        <translation>le nœud&#xa0;%1 est plus épais que son parent&#xa0;: rayon&#xa0;%2 sur&#xa0;%3</translation>
    </message>
    <message>
        <source>node %1 is thicker than its parent</source>
        <translation>le nœud&#xa0;%1 est plus épais que son parent</translation>
    </message>
    <message>
        <source>%2 from node %1 on are far from any point</source>
        <translation>%2 à partir du nœud&#xa0;%1 sont loin de tout point</translation>
    </message>
    <message>
        <source>the branch at node %1 has no points of its own along its first %2</source>
        <translation>la branche au nœud&#xa0;%1 n’a pas de points propres sur ses premiers&#xa0;%2</translation>
    </message>
    <message>
        <source>node %1 lies %2 beside its points</source>
        <translation>le nœud&#xa0;%1 est à&#xa0;%2 à côté de ses points</translation>
    </message>
    <message>
        <source>the points of the stem go on by %2 below node %1</source>
        <translation>les points de la tige continuent sur&#xa0;%2 sous le nœud&#xa0;%1</translation>
    </message>
    <message>
        <source>bare twig, 1 point, %2 long, near node %1</source>
        <translation>brindille nue, 1 point, longue de&#xa0;%2, près du nœud&#xa0;%1</translation>
    </message>
    <message>
        <source>bare twig, %3 points, %2 long, near node %1</source>
        <translation>brindille nue,&#xa0;%3 points, longue de&#xa0;%2, près du nœud&#xa0;%1</translation>
    </message>
    <message>
        <source>there is no node between the ends: choose the two ends of a longer path</source>
        <translation>il n’y a pas de nœud entre les extrémités&#xa0;: choisissez les deux extrémités d’un chemin plus long</translation>
    </message>
    <message>
        <source>edges that short would make over a million nodes: choose a greater length</source>
        <translation>des arêtes aussi courtes feraient plus d’un million de nœuds&#xa0;: choisissez une longueur plus grande</translation>
    </message>
    <message>
        <source>node %1 has no radius yet: type one in the inspector first</source>
        <translation>le nœud&#xa0;%1 n’a pas encore de rayon&#xa0;: saisissez-en d’abord un dans l’inspecteur</translation>
    </message>
    <message>
        <source>all nodes between the ends branch, or a unit starts there: nothing can go</source>
        <translation>tous les nœuds entre les extrémités ramifient, ou une unité y commence&#xa0;: rien ne peut être retiré</translation>
    </message>
    <message>
        <source>the chosen nodes have no radius yet: type one in the inspector first</source>
        <translation>les nœuds choisis n’ont pas encore de rayon&#xa0;: saisissez-en d’abord un dans l’inspecteur</translation>
    </message>
    <message>
        <source>node %1 and node %2 belong to different trees: choose two of one tree, or join them first</source>
        <translation>les nœuds&#xa0;%1 et&#xa0;%2 sont d’arbres différents&#xa0;: choisissez-en deux d’un même arbre, ou joignez-les d’abord</translation>
    </message>
    <message>
        <source>the parent, node %1, does not exist: choose another</source>
        <translation>le parent, le nœud&#xa0;%1, n’existe pas&#xa0;: choisissez-en un autre</translation>
    </message>
    <message>
        <source>node %1 does not exist: choose another parent</source>
        <translation>le nœud&#xa0;%1 n’existe pas&#xa0;: choisissez un autre parent</translation>
    </message>
    <message>
        <source>cannot attach node %1 to node %2, which it carries itself: choose a parent outside its branch</source>
        <translation>impossible d’attacher le nœud&#xa0;%1 au nœud&#xa0;%2, qu’il porte lui-même&#xa0;: choisissez un parent hors de sa branche</translation>
    </message>
    <message>
        <source>node %1 and node %2 are not connected: choose nodes linked by edges, or children of one node</source>
        <translation>les nœuds&#xa0;%1 et&#xa0;%2 ne sont pas reliés&#xa0;: choisissez des nœuds liés par des arêtes, ou les enfants d’un même nœud</translation>
    </message>
    <message>
        <source>node %1 does not branch: choose a node with two children or more</source>
        <translation>le nœud&#xa0;%1 ne ramifie pas&#xa0;: choisissez un nœud qui a deux enfants ou plus</translation>
    </message>
    <message>
        <source>node %1 is a root already: choose a node above it</source>
        <translation>le nœud&#xa0;%1 est déjà une racine&#xa0;: choisissez un nœud plus haut</translation>
    </message>
    <message>
        <source>node %1 and node %2 belong to one tree: reparent one to the other instead</source>
        <translation>les nœuds&#xa0;%1 et&#xa0;%2 sont d’un même arbre&#xa0;: rattachez plutôt l’un à l’autre</translation>
    </message>
    <message>
        <source>the plant is one tree: there is nothing to join node %1 to</source>
        <translation>la plante est un seul arbre&#xa0;: il n’y a rien à quoi joindre le nœud&#xa0;%1</translation>
    </message>
    <message>
        <source>node %1 does not carry node %2: choose the two ends of a path that leads upward</source>
        <translation>le nœud&#xa0;%1 ne porte pas le nœud&#xa0;%2&#xa0;: choisissez les deux extrémités d’un chemin qui monte</translation>
    </message>
    <message>
        <source>there is one node only: choose two or more to merge</source>
        <translation>il n’y a qu’un nœud&#xa0;: choisissez-en deux ou plus à fusionner</translation>
    </message>
    <message>
        <source>corners</source>
        <translation>sommets</translation>
    </message>
    <message>
        <source>middle of the outline</source>
        <translation>milieu du contour</translation>
    </message>
    <message>
        <source>lower end of the axis</source>
        <translation>extrémité basse de l’axe</translation>
    </message>
    <message>
        <source>upper end of the axis</source>
        <translation>extrémité haute de l’axe</translation>
    </message>
    <message>
        <source>base</source>
        <translation>base</translation>
    </message>
    <message>
        <source>For trees and shrubs in winter: as by default; no other settings were better on simulated ones.</source>
        <translation>Pour les arbres et arbustes en hiver&#xa0;: comme par défaut&#xa0;; aucun autre réglage n’était meilleur sur des plantes simulées.</translation>
    </message>
    <message>
        <source>For conifers with needles: as by default; no other settings were better on simulated ones.</source>
        <translation>Pour les conifères à aiguilles&#xa0;: comme par défaut&#xa0;; aucun autre réglage n’était meilleur sur des plantes simulées.</translation>
    </message>
    <message>
        <source>For trees and shrubs in leaf: as by default; no other settings were better on simulated ones.</source>
        <translation>Pour les arbres et arbustes feuillés&#xa0;: comme par défaut&#xa0;; aucun autre réglage n’était meilleur sur des plantes simulées.</translation>
    </message>
    <message>
        <source>For herbs with leaves on petioles: more ends, also of those that are less probably midribs than not.</source>
        <translation>Pour les herbacées à feuilles pétiolées&#xa0;: plus d’extrémités, dont celles qui sont peut-être des nervures médianes.</translation>
    </message>
    <message>
        <source>For grasses such as maize: as by default; no other settings were better on simulated ones.</source>
        <translation>Pour les graminées comme le maïs&#xa0;: comme par défaut&#xa0;; aucun autre réglage n’était meilleur sur des plantes simulées.</translation>
    </message>
    <message>
        <source>nothing grows from these points: they are too few, or too far from the plant; choose others, or trace the branch</source>
        <translation>rien ne pousse à partir de ces points&#xa0;: ils sont trop peu nombreux, ou trop loin de la plante&#xa0;; choisissez-en d’autres, ou tracez la branche</translation>
    </message>
    <message>
        <source>the skeleton explains all points: there is nothing to grow</source>
        <translation>le squelette explique tous les points&#xa0;: il n’y a rien à faire pousser</translation>
    </message>
    <message>
        <source>Wood that touches is reported where the path from one to the other is longer than so many sums of their radii.</source>
        <translation>Du bois qui se touche est signalé là où le chemin de l’un à l’autre est plus long que ce nombre de fois la somme de leurs rayons.</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>Anneau</translation>
    </message>
    <message>
        <source>Two sides of wood that lie nearer to each other than this, in bin widths, and part below and meet above, are one; 0 keeps both.</source>
        <translation>Deux côtés du bois plus proches l’un de l’autre que cela, en largeurs de classe, qui se séparent plus bas et se rejoignent plus haut, n’en font qu’un&#xa0;; 0 garde les deux.</translation>
    </message>
    <message>
        <source>of %1 points, %2 % are of wood, %3 % of petioles, %4 % of blades and %5 % of needles</source>
        <translation>sur %1 points, %2&#xa0;% sont de bois, %3&#xa0;% de pétioles, %4&#xa0;% de limbes et %5&#xa0;% d’aiguilles</translation>
    </message>
    <message>
        <source>of %1 points, %2 % are of wood, %3 % of petioles, %4 % of blades and %5 % of needles; %6 were set by hand</source>
        <translation>sur %1 points, %2&#xa0;% sont de bois, %3&#xa0;% de pétioles, %4&#xa0;% de limbes et %5&#xa0;% d’aiguilles&#xa0;; %6 ont été fixés à la main</translation>
    </message>
    <message>
        <source>no wood would be left: nothing is left out</source>
        <translation>il ne resterait pas de bois&#xa0;: rien n’est écarté</translation>
    </message>
    <message>
        <source>no blades are known: turn on the step Leaves</source>
        <translation>aucun limbe n’est connu&#xa0;: activez l’étape Feuilles</translation>
    </message>
    <message>
        <source>no radius is measured, so there are no radii: check the scan</source>
        <translation>aucun rayon n’est mesuré, il n’y a donc pas de rayons&#xa0;: vérifiez le scan</translation>
    </message>
    <message>
        <source>the foot measures %1 times the tips, which fits no pipe model: radii are a guess; they have the exponent of published structures, 1/%2, from the foot up</source>
        <translation>le pied mesure %1&#xa0;fois les extrémités, ce qui ne convient à aucun modèle des tuyaux&#xa0;: les rayons sont une conjecture&#xa0;; ils ont l’exposant de structures publiées, 1/%2, à partir du pied</translation>
    </message>
    <message>
        <source>nothing is measured at the tips: radii are a guess; they have the exponent of published structures, 1/%1, from the foot up</source>
        <translation>rien n’est mesuré aux extrémités&#xa0;: les rayons sont une conjecture&#xa0;; ils ont l’exposant de structures publiées, 1/%1, à partir du pied</translation>
    </message>
    <message>
        <source>nothing is measured at the foot: radii are a guess; they have the exponent of published structures, 1/%1, from the tips down</source>
        <translation>rien n’est mesuré au pied&#xa0;: les rayons sont une conjecture&#xa0;; ils ont l’exposant de structures publiées, 1/%1, à partir des extrémités</translation>
    </message>
    <message>
        <source>no radius is measured: radii are a guess; they have the exponent of published structures, 1/%1, from tips half as thick as the points are apart</source>
        <translation>aucun rayon n’est mesuré&#xa0;: les rayons sont une conjecture&#xa0;; ils ont l’exposant de structures publiées, 1/%1, à partir d’extrémités moitié moins épaisses que l’écart entre les points</translation>
    </message>
    <message>
        <source>%1 of %2 ends are removed, most of them probably edges of leaves or needles, and more of these may be left: for a herb or a seedling, try the settings Leaves (--preset leaves)</source>
        <translation>%1&#xa0;extrémités sur %2 sont supprimées, la plupart sans doute des bords de feuilles ou des aiguilles, et il peut en rester&#xa0;: pour une herbe ou une plantule, essayez les réglages Feuilles (--preset leaves)</translation>
    </message>
    <message>
        <source>no pole was found</source>
        <translation>aucun poteau n’a été trouvé</translation>
    </message>
    <message>
        <source>1 pole left out</source>
        <translation>1&#xa0;poteau écarté</translation>
    </message>
    <message>
        <source>%1 poles left out</source>
        <translation>%1&#xa0;poteaux écartés</translation>
    </message>
    <message>
        <source>no wire was found</source>
        <translation>aucun câble n’a été trouvé</translation>
    </message>
    <message>
        <source>1 wire left out</source>
        <translation>1&#xa0;câble écarté</translation>
    </message>
    <message>
        <source>%1 wires left out</source>
        <translation>%1&#xa0;câbles écartés</translation>
    </message>
    <message>
        <source>no stem was found, so all points are kept</source>
        <translation>aucune tige n’a été trouvée, tous les points sont donc gardés</translation>
    </message>
    <message>
        <source>plant %1 of %2 kept</source>
        <translation>plante %1 sur %2 gardée</translation>
    </message>
    <message>
        <source>%1 of %2 points are used: more do not make the skeleton better</source>
        <translation>%1&#xa0;points sur %2 sont utilisés&#xa0;: davantage n’améliore pas le squelette</translation>
    </message>
    <message>
        <source>3D mice</source>
        <translation>souris 3D</translation>
    </message>
    <message>
        <source>coordinates so far from 0 are those of a map</source>
        <translation>des coordonnées si loin de 0 sont celles d’une carte</translation>
    </message>
    <message>
        <source>it would be %1 m, %1 cm or %1 mm large: choose which it is</source>
        <translation>elle ferait %1 m, %1 cm ou %1 mm&#xa0;: choisissez ce qu’il en est</translation>
    </message>
    <message>
        <source>the size does not show it</source>
        <translation>la taille ne le montre pas</translation>
    </message>
    <message>
        <source>in m it would be %1 m large, as no plant is</source>
        <translation>en m elle ferait %1 m, ce qu’aucune plante n’atteint</translation>
    </message>
    <message>
        <source>in mm it would be %1 mm large, as few plants are</source>
        <translation>en mm elle ferait %1 mm, ce qui est rare pour une plante</translation>
    </message>
    <message>
        <source>as most scans have it; no foot of a plant is seen</source>
        <translation>comme dans la plupart des scans&#xa0;; aucun pied de plante n’est visible</translation>
    </message>
    <message>
        <source>at the low end of %1 points stand together, as at a foot</source>
        <translation>au bas de %1, des points sont serrés comme à un pied</translation>
    </message>
    <message>
        <source>E57 is in meters</source>
        <translation>E57 est en mètres</translation>
    </message>
    <message>
        <source>E57 has z up</source>
        <translation>E57 a z vers le haut</translation>
    </message>
    <message>
        <source>its map projection is in meters</source>
        <translation>sa projection cartographique est en mètres</translation>
    </message>
    <message>
        <source>its map projection is in feet, which have no name here: lengths are shown without a unit</source>
        <translation>sa projection cartographique est en pieds, qui n’ont pas de nom ici&#xa0;: les longueurs sont affichées sans unité</translation>
    </message>
    <message>
        <source>LAS has heights along z</source>
        <translation>LAS a les hauteurs selon z</translation>
    </message>
    <message>
        <source>PTX is in meters</source>
        <translation>PTX est en mètres</translation>
    </message>
    <message>
        <source>scanners that write PTX stand along z</source>
        <translation>les scanners qui écrivent PTX se tiennent selon z</translation>
    </message>
    <message>
        <source>as the open scan</source>
        <translation>comme le scan ouvert</translation>
    </message>
    <message>
        <source>the plant lay %1 off the reference: it was turned by %2 degrees about %3 and moved by %4 to lie on it</source>
        <translation>la plante était à %1 de la référence&#xa0;: elle a été tournée de %2 degrés autour de %3 et déplacée de %4 pour s’y superposer</translation>
    </message>
    <message>
        <source>the plant lay %1 off the reference: it was moved by %2 to lie on it</source>
        <translation>la plante était à %1 de la référence&#xa0;: elle a été déplacée de %2 pour s’y superposer</translation>
    </message>
    <message>
        <source>the edit distance of %1 and %2 parts would take too long and is left out: compare segments or axes</source>
        <translation>la distance d’édition de %1 et %2 parties prendrait trop de temps et n’est pas calculée&#xa0;: comparez des segments ou des axes</translation>
    </message>
    <message>
        <source>the plant is of %1 separate trees, compared as one plant: keep one of them if they are not</source>
        <translation>la plante est faite de %1 arbres séparés, comparés comme une seule plante&#xa0;: n’en gardez qu’un s’ils n’en sont pas une</translation>
    </message>
    <message>
        <source>the reference is of %1 separate trees, compared as one plant: keep one of them if they are not</source>
        <translation>la référence est faite de %1 arbres séparés, comparés comme une seule plante&#xa0;: n’en gardez qu’un s’ils n’en sont pas une</translation>
    </message>
    <message>
        <source>the plant is of %1 separate trees, measured as one plant: keep one of them if they are not</source>
        <translation>la plante est faite de %1 arbres séparés, mesurés comme une seule plante&#xa0;: n’en gardez qu’un s’ils n’en sont pas une</translation>
    </message>
    <message>
        <source>the plant has no radii: its light is left out; estimate radii first</source>
        <translation>la plante n’a pas de rayons&#xa0;: sa lumière n’est pas calculée&#xa0;; estimez d’abord les rayons</translation>
    </message>
    <message>
        <source>the reference has no radii: its light is left out; estimate radii first</source>
        <translation>la référence n’a pas de rayons&#xa0;: sa lumière n’est pas calculée&#xa0;; estimez d’abord les rayons</translation>
    </message>
    <message>
        <source>the plant is %1 times as large as the reference: check that both are in the same unit and of the same plant</source>
        <translation>la plante est %1 fois plus grande que la référence&#xa0;: vérifiez que les deux ont la même unité et sont de la même plante</translation>
    </message>
    <message>
        <source>the plant is %1 times as small as the reference: check that both are in the same unit and of the same plant</source>
        <translation>la plante est %1 fois plus petite que la référence&#xa0;: vérifiez que les deux ont la même unité et sont de la même plante</translation>
    </message>
    <message>
        <source>the plant is %1 times as large as the reference: it seems to be in %2, the reference in %3; scale the plant by %4</source>
        <translation>la plante est %1 fois plus grande que la référence&#xa0;: elle semble être en %2, la référence en %3&#xa0;; multipliez la plante par %4</translation>
    </message>
    <message>
        <source>the plant is %1 times as small as the reference: it seems to be in %2, the reference in %3; scale the plant by %4</source>
        <translation>la plante est %1 fois plus petite que la référence&#xa0;: elle semble être en %2, la référence en %3&#xa0;; multipliez la plante par %4</translation>
    </message>
    <message>
        <source>the two fit poorly: laid on each other, %1 % of their length lies within %2 of the other, an eighth of a mean segment: check that they are of the same plant</source>
        <translation>les deux s’accordent mal&#xa0;: superposés, %1 % de leur longueur est à moins de %2 de l’autre, un huitième d’un segment moyen&#xa0;: vérifiez qu’ils sont de la même plante</translation>
    </message>
    <message>
        <source>hardly anything of the two lies within %1 of the other: check that they are of the same plant</source>
        <translation>presque rien de l’un n’est à moins de %1 de l’autre&#xa0;: vérifiez qu’ils sont de la même plante</translation>
    </message>
    <message>
        <source>hardly anything of the two lies within %1 of the other: check that they are of the same plant and in the same frame, or let the plant be registered</source>
        <translation>presque rien de l’un n’est à moins de %1 de l’autre&#xa0;: vérifiez qu’ils sont de la même plante et dans le même repère, ou laissez superposer la plante</translation>
    </message>
    <message>
        <source>%1 keeps no radii: how thick the nodes are is not written</source>
        <translation>%1 ne garde pas les rayons&#xa0;: l’épaisseur des nœuds n’est pas écrite</translation>
    </message>
    <message>
        <source>%1 keeps no edge types: which child continues an axis is not written</source>
        <translation>%1 ne garde pas les types d’arêtes&#xa0;: l’enfant qui continue un axe n’est pas écrit</translation>
    </message>
    <message>
        <source>%1 keeps one tree only: the others are not written</source>
        <translation>%1 ne garde qu’un arbre&#xa0;: les autres ne sont pas écrits</translation>
    </message>
    <message>
        <source>%1 keeps no classes or scales: units and axes that the nodes belong to are not written</source>
        <translation>%1 ne garde ni classes ni échelles&#xa0;: les unités et axes des nœuds ne sont pas écrits</translation>
    </message>
    <message>
        <source>%1 keeps no labels: indices and aliases are not written</source>
        <translation>%1 ne garde pas les étiquettes&#xa0;: indices et alias ne sont pas écrits</translation>
    </message>
    <message>
        <source>%1 keeps no features: values beside position and radius are not written</source>
        <translation>%1 ne garde pas les attributs&#xa0;: les valeurs autres que position et rayon ne sont pas écrites</translation>
    </message>
    <message>
        <source>%1 keeps one date only: values at later dates are not written</source>
        <translation>%1 ne garde qu’une date&#xa0;: les valeurs des dates suivantes ne sont pas écrites</translation>
    </message>
    <message>
        <source>%1 keeps no marks of unit starts: they are not written; only a project keeps them</source>
        <translation>%1 ne garde pas les marques de début d’unité&#xa0;: elles ne sont pas écrites&#xa0;; seul un projet les garde</translation>
    </message>
    <message>
        <source>%1 keeps no review: marks, comments and signatures are not written; only a project keeps them</source>
        <translation>%1 ne garde pas la révision&#xa0;: marques, commentaires et signatures ne sont pas écrits&#xa0;; seul un projet les garde</translation>
    </message>
    <message>
        <source>registration: the starting motion is not finite</source>
        <translation>recalage&#xa0;: le mouvement de départ n’est pas fini</translation>
    </message>
    <message>
        <source>no sphere of radius %3 about %1: only 1 point is near: pick its middle, and check the radius</source>
        <translation>pas de sphère de rayon %3 autour de %1&#xa0;: un seul point est proche&#xa0;: pointez son milieu, et vérifiez le rayon</translation>
    </message>
    <message>
        <source>no sphere about %1: only 1 point is near: pick its middle, and check the radius</source>
        <translation>pas de sphère autour de %1&#xa0;: un seul point est proche&#xa0;: pointez son milieu, et vérifiez le rayon</translation>
    </message>
    <message>
        <source>no sphere of radius %3 about %1: only %2 points are near: pick its middle, and check the radius</source>
        <translation>pas de sphère de rayon %3 autour de %1&#xa0;: seuls %2 points sont proches&#xa0;: pointez son milieu, et vérifiez le rayon</translation>
    </message>
    <message>
        <source>no sphere about %1: only %2 points are near: pick its middle, and check the radius</source>
        <translation>pas de sphère autour de %1&#xa0;: seuls %2 points sont proches&#xa0;: pointez son milieu, et vérifiez le rayon</translation>
    </message>
    <message>
        <source>no sphere of radius %3 about %1: the points there lie on none: pick its middle, and check the radius</source>
        <translation>pas de sphère de rayon %3 autour de %1&#xa0;: les points qui s’y trouvent ne sont sur aucune&#xa0;: pointez son milieu, et vérifiez le rayon</translation>
    </message>
    <message>
        <source>no sphere about %1: the points there lie on none: pick its middle, and check the radius</source>
        <translation>pas de sphère autour de %1&#xa0;: les points qui s’y trouvent ne sont sur aucune&#xa0;: pointez son milieu, et vérifiez le rayon</translation>
    </message>
    <message>
        <source>no sphere of radius %3 about %1: only 1 point lies on the likeliest: pick its middle, and check the radius</source>
        <translation>pas de sphère de rayon %3 autour de %1&#xa0;: un seul point est sur la plus probable&#xa0;: pointez son milieu, et vérifiez le rayon</translation>
    </message>
    <message>
        <source>no sphere about %1: only 1 point lies on the likeliest: pick its middle, and check the radius</source>
        <translation>pas de sphère autour de %1&#xa0;: un seul point est sur la plus probable&#xa0;: pointez son milieu, et vérifiez le rayon</translation>
    </message>
    <message>
        <source>no sphere of radius %3 about %1: only %2 points lie on the likeliest: pick its middle, and check the radius</source>
        <translation>pas de sphère de rayon %3 autour de %1&#xa0;: seuls %2 points sont sur la plus probable&#xa0;: pointez son milieu, et vérifiez le rayon</translation>
    </message>
    <message>
        <source>no sphere about %1: only %2 points lie on the likeliest: pick its middle, and check the radius</source>
        <translation>pas de sphère autour de %1&#xa0;: seuls %2 points sont sur la plus probable&#xa0;: pointez son milieu, et vérifiez le rayon</translation>
    </message>
    <message>
        <source>no sphere of radius %3 about %1: too little of it is seen: pick its middle, and check the radius</source>
        <translation>pas de sphère de rayon %3 autour de %1&#xa0;: on en voit trop peu&#xa0;: pointez son milieu, et vérifiez le rayon</translation>
    </message>
    <message>
        <source>no sphere about %1: too little of it is seen: pick its middle, and check the radius</source>
        <translation>pas de sphère autour de %1&#xa0;: on en voit trop peu&#xa0;: pointez son milieu, et vérifiez le rayon</translation>
    </message>
    <message>
        <source>no sphere of radius %3 about %1: over half of the points about it lie off it: pick its middle, and check the radius</source>
        <translation>pas de sphère de rayon %3 autour de %1&#xa0;: plus de la moitié des points qui l’entourent n’y sont pas&#xa0;: pointez son milieu, et vérifiez le rayon</translation>
    </message>
    <message>
        <source>no sphere about %1: over half of the points about it lie off it: pick its middle, and check the radius</source>
        <translation>pas de sphère autour de %1&#xa0;: plus de la moitié des points qui l’entourent n’y sont pas&#xa0;: pointez son milieu, et vérifiez le rayon</translation>
    </message>
    <message>
        <source>a target sphere: expected a finite place, and a radius and reach over 0</source>
        <translation>une sphère de cible&#xa0;: un endroit fini est attendu, ainsi qu’un rayon et une portée supérieurs à 0</translation>
    </message>
    <message>
        <source>its place or radius is beyond 1e12, as of no plant: correct or remove it</source>
        <translation>sa position ou son rayon dépasse 1e12, ce qu’aucune plante n’atteint&#xa0;: corrigez-le ou retirez-le</translation>
    </message>
    <message>
        <source>the Delaunay triangulation of the points could not be found</source>
        <translation>la triangulation de Delaunay des points n’a pas pu être calculée</translation>
    </message>
    <message>
        <source>and 1 note more</source>
        <translation>et 1 autre remarque</translation>
    </message>
    <message>
        <source>and %1 notes more</source>
        <translation>et %1 autres remarques</translation>
    </message>
    <message>
        <source>there is no such file: check its name and folder</source>
        <translation>ce fichier n’existe pas&#xa0;: vérifiez son nom et son dossier</translation>
    </message>
    <message>
        <source>may not be read: change its rights, or choose another file</source>
        <translation>n’a pas le droit d’être lu&#xa0;: changez ses droits, ou choisissez un autre fichier</translation>
    </message>
    <message>
        <source>cannot be read: %1; try a copy of it</source>
        <translation>ne peut pas être lu&#xa0;: %1&#xa0;; essayez une copie</translation>
    </message>
    <message>
        <source>is a folder, choose a file in it</source>
        <translation>est un dossier&#xa0;: choisissez-y un fichier</translation>
    </message>
    <message>
        <source>is a pipe or device: save it as a file and open that</source>
        <translation>est un tube ou un périphérique&#xa0;: enregistrez-le dans un fichier et ouvrez celui-ci</translation>
    </message>
    <message>
        <source>the convex hull of the points could not be found</source>
        <translation>l’enveloppe convexe des points n’a pas pu être calculée</translation>
    </message>
    <message>
        <source>expected a number as %1, found %2</source>
        <translation>un nombre est attendu pour %1, trouvé %2</translation>
    </message>
    <message>
        <source>is text of two bytes per character (UTF-16, &quot;Unicode Text&quot; in Excel), which cannot be read: save it as UTF-8, or in Excel as &quot;Text (Tab delimited)&quot;</source>
        <translation>est un texte de deux octets par caractère (UTF-16, «&#xa0;Texte Unicode&#xa0;» dans Excel), qui ne peut pas être lu&#xa0;: enregistrez-le en UTF-8, ou dans Excel en «&#xa0;Texte (séparateur&#xa0;: tabulation)&#xa0;»</translation>
    </message>
    <message>
        <source>the scans have over 4 294 967 295 points together: thin them first</source>
        <translation>les scans ont ensemble plus de 4 294 967 295 points&#xa0;: éclaircissez-les d’abord</translation>
    </message>
    <message>
        <source>the scans have over 65536 stations together: join fewer of them</source>
        <translation>les scans ont ensemble plus de 65536 stations&#xa0;: joignez-en moins</translation>
    </message>
    <message>
        <source>stored points are not complete: open the scan again</source>
        <translation>les points enregistrés ne sont pas complets&#xa0;: ouvrez à nouveau le scan</translation>
    </message>
    <message>
        <source>stored points are not all finite, or beyond any plant: open the scan again</source>
        <translation>les points enregistrés ne sont pas tous finis, ou sont plus loin que toute plante&#xa0;: ouvrez à nouveau le scan</translation>
    </message>
    <message>
        <source>contraction with no weight along and none across has no end: raise one of them</source>
        <translation>une contraction sans poids le long ni en travers n’a pas de fin&#xa0;: augmentez l’un des deux</translation>
    </message>
    <message>
        <source>the surface has a corner that is no number: correct the radii and positions</source>
        <translation>la surface a un coin qui n’est pas un nombre&#xa0;: corrigez les rayons et les positions</translation>
    </message>
    <message>
        <source>the surface has no area: estimate radii first</source>
        <translation>la surface a une aire nulle&#xa0;: estimez d’abord les rayons</translation>
    </message>
    <message>
        <source>distance %1: expected a length above 0</source>
        <translation>distance %1&#xa0;: une longueur supérieure à 0 est attendue</translation>
    </message>
    <message>
        <source>the plant has no nodes: choose a structure with positions</source>
        <translation>la plante n’a pas de nœuds&#xa0;: choisissez une structure avec des positions</translation>
    </message>
    <message>
        <source>the plant, node %1: its position is not a number: correct or delete the node</source>
        <translation>la plante, nœud %1&#xa0;: sa position n’est pas un nombre&#xa0;: corrigez ou supprimez le nœud</translation>
    </message>
    <message>
        <source>the plant has no length: its nodes are not linked or all lie at one place; choose another structure</source>
        <translation>la plante n’a pas de longueur&#xa0;: ses nœuds ne sont pas liés ou sont tous au même endroit&#xa0;; choisissez une autre structure</translation>
    </message>
    <message>
        <source>the reference has no nodes: choose a structure with positions</source>
        <translation>la référence n’a pas de nœuds&#xa0;: choisissez une structure avec des positions</translation>
    </message>
    <message>
        <source>the reference, node %1: its position is not a number: correct or delete the node</source>
        <translation>la référence, nœud %1&#xa0;: sa position n’est pas un nombre&#xa0;: corrigez ou supprimez le nœud</translation>
    </message>
    <message>
        <source>the reference has no length: its nodes are not linked or all lie at one place; choose another structure</source>
        <translation>la référence n’a pas de longueur&#xa0;: ses nœuds ne sont pas liés ou sont tous au même endroit&#xa0;; choisissez une autre structure</translation>
    </message>
    <message>
        <source>%2 has no nodes: choose a structure with positions</source>
        <translation>%2 n’a pas de nœuds&#xa0;: choisissez une structure avec des positions</translation>
    </message>
    <message>
        <source>%2, node %1: its position is not a number: correct or delete the node</source>
        <translation>%2, nœud %1&#xa0;: sa position n’est pas un nombre&#xa0;: corrigez ou supprimez le nœud</translation>
    </message>
    <message>
        <source>%2 has no length: its nodes are not linked or all lie at one place; choose another structure</source>
        <translation>%2 n’a pas de longueur&#xa0;: ses nœuds ne sont pas liés ou sont tous au même endroit&#xa0;; choisissez une autre structure</translation>
    </message>
    <message>
        <source>the edit distance of %1 and %2 parts takes too much memory: compare a coarser scale</source>
        <translation>la distance d’édition de %1 et %2 parties demande trop de mémoire&#xa0;: comparez à une échelle plus grossière</translation>
    </message>
    <message>
        <source>tolerance %1: expected a length of 0 or more</source>
        <translation>tolérance %1&#xa0;: une longueur de 0 ou plus est attendue</translation>
    </message>
    <message>
        <source>cannot be written: %1; free some room or choose another disk</source>
        <translation>ne peut pas être écrit&#xa0;: %1&#xa0;; libérez de la place ou choisissez un autre disque</translation>
    </message>
    <message>
        <source>cannot be written: %1; choose another name, or a folder you may write to</source>
        <translation>ne peut pas être écrit&#xa0;: %1&#xa0;; choisissez un autre nom, ou un dossier où vous pouvez écrire</translation>
    </message>
    <message>
        <source>cannot be written: %1; create the folder first or choose another</source>
        <translation>ne peut pas être écrit&#xa0;: %1&#xa0;; créez d’abord le dossier ou choisissez-en un autre</translation>
    </message>
    <message>
        <source>cannot be written: %1; choose a file name</source>
        <translation>ne peut pas être écrit&#xa0;: %1&#xa0;; choisissez un nom de fichier</translation>
    </message>
    <message>
        <source>cannot be written: %1; choose a shorter name</source>
        <translation>ne peut pas être écrit&#xa0;: %1&#xa0;; choisissez un nom plus court</translation>
    </message>
    <message>
        <source>cannot be written: %1; try another place</source>
        <translation>ne peut pas être écrit&#xa0;: %1&#xa0;; essayez un autre endroit</translation>
    </message>
    <message>
        <source>ends within a text: the file is cut short or damaged, copy or export it again</source>
        <translation>s’arrête au milieu d’un texte&#xa0;: le fichier est tronqué ou abîmé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>ends within a value of %1 bytes: the file is cut short or damaged, copy or export it again</source>
        <translation>s’arrête au milieu d’une valeur de %1 octets&#xa0;: le fichier est tronqué ou abîmé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>the XML is broken here (%1): copy or export the file again</source>
        <translation>le XML est abîmé ici (%1)&#xa0;: copiez ou exportez à nouveau le fichier</translation>
    </message>
    <message>
        <source>expected an element %1, found %2</source>
        <translation>un élément %1 est attendu, trouvé %2</translation>
    </message>
    <message>
        <source>the document defines entities, which are not read: export it without them</source>
        <translation>le document définit des entités, qui ne sont pas lues&#xa0;: exportez-le sans elles</translation>
    </message>
    <message>
        <source>its elements are nested over %1 deep, as in no plant</source>
        <translation>ses éléments sont imbriqués sur plus de %1 niveaux, comme dans aucune plante</translation>
    </message>
    <message>
        <source>a quote is not closed: end the field with &quot;</source>
        <translation>un guillemet n’est pas fermé&#xa0;: terminez le champ par &quot;</translation>
    </message>
    <message>
        <source>there is text behind a quoted field: quote all of it, and write &quot;&quot; for a quote in it</source>
        <translation>du texte suit un champ entre guillemets&#xa0;: mettez-le tout entre guillemets, et écrivez &quot;&quot; pour un guillemet à l’intérieur</translation>
    </message>
    <message>
        <source>there are %1 columns, more than in any such table: leave out those that are not needed</source>
        <translation>il y a %1 colonnes, plus que dans tout tableau de cette sorte&#xa0;: retirez celles qui ne servent pas</translation>
    </message>
    <message>
        <source>two columns are named %1: rename one</source>
        <translation>deux colonnes s’appellent %1&#xa0;: renommez-en une</translation>
    </message>
    <message>
        <source>there are no names of columns: begin with a line of names</source>
        <translation>il n’y a pas de noms de colonnes&#xa0;: commencez par une ligne de noms</translation>
    </message>
    <message>
        <source>expected %1 fields, found %2: quote fields that hold the sign that parts them</source>
        <translation>%1 champs sont attendus, trouvé %2&#xa0;: mettez entre guillemets les champs qui contiennent le signe qui les sépare</translation>
    </message>
    <message>
        <source>is empty: copy or export it again</source>
        <translation>est vide&#xa0;: copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>is of no known kind; can be read: %1</source>
        <translation>n’est d’aucun type connu&#xa0;; peuvent être lus&#xa0;: %1</translation>
    </message>
    <message>
        <source>is %1, which cannot be read: open the structure that it was written from</source>
        <translation>est du type %1, qui ne peut pas être lu&#xa0;: ouvrez la structure à partir de laquelle il a été écrit</translation>
    </message>
    <message>
        <source>holds a structure (%1), not points: choose a scan</source>
        <translation>contient une structure (%1), pas des points&#xa0;: choisissez un scan</translation>
    </message>
    <message>
        <source>holds points (%1), not a structure: choose an MTG or a node list</source>
        <translation>contient des points (%1), pas une structure&#xa0;: choisissez un MTG ou une liste de nœuds</translation>
    </message>
    <message>
        <source>none of its %1 points lies in the box from %2 to %3: choose another</source>
        <translation>aucun de ses %1 points n’est dans la boîte de %2 à %3&#xa0;: choisissez-en une autre</translation>
    </message>
    <message>
        <source>none of its %1 points lies in the box from %2 to %3: they lie from %4 to %5</source>
        <translation>aucun de ses %1 points n’est dans la boîte de %2 à %3&#xa0;: ils vont de %4 à %5</translation>
    </message>
    <message>
        <source>%1 of %2 points are read, those in the box</source>
        <translation>%1 points sur %2 sont lus, ceux de la boîte</translation>
    </message>
    <message>
        <source>%1 of %2 points are read, a sample of all</source>
        <translation>%1 points sur %2 sont lus, un échantillon de tous</translation>
    </message>
    <message>
        <source>%1 of %2 points are read, a sample of those in the box</source>
        <translation>%1 points sur %2 sont lus, un échantillon de ceux de la boîte</translation>
    </message>
    <message>
        <source>a node at %1, with radius %2: its place or radius is beyond 1e12, as of no plant: correct or remove it</source>
        <translation>un nœud en %1, de rayon %2&#xa0;: sa position ou son rayon dépasse 1e12, ce qu’aucune plante n’atteint&#xa0;: corrigez-le ou retirez-le</translation>
    </message>
    <message>
        <source>its branches are nested too deeply</source>
        <translation>ses branches sont imbriquées trop profondément</translation>
    </message>
    <message>
        <source>cannot be written as MTG text (%1): a project keeps its skeleton, without the rest of the MTG</source>
        <translation>ne peut pas être écrit en texte MTG (%1)&#xa0;: un projet garde son squelette, sans le reste du MTG</translation>
    </message>
    <message>
        <source>points cannot be written with this extension; choose one of %1</source>
        <translation>des points ne peuvent pas être écrits avec cette extension&#xa0;; choisissez parmi %1</translation>
    </message>
    <message>
        <source>a structure cannot be written with this extension; choose one of %1</source>
        <translation>une structure ne peut pas être écrite avec cette extension&#xa0;; choisissez parmi %1</translation>
    </message>
    <message>
        <source>is %1, which says itself what its columns hold: name columns of text files alone</source>
        <translation>est du type %1, qui dit lui-même ce que contiennent ses colonnes&#xa0;: ne nommez que les colonnes de fichiers texte</translation>
    </message>
    <message>
        <source>holds no points: export it again</source>
        <translation>ne contient pas de points&#xa0;: exportez-le à nouveau</translation>
    </message>
    <message>
        <source>holds %1 points, none of them finite: export it again</source>
        <translation>contient %1 points, dont aucun n’est fini&#xa0;: exportez-le à nouveau</translation>
    </message>
    <message>
        <source>%1 needs positions, and the structure has none: choose MTG or OPF</source>
        <translation>%1 a besoin de positions, et la structure n’en a pas&#xa0;: choisissez MTG ou OPF</translation>
    </message>
    <message>
        <source>objects are nested deeper than %1: the file is damaged</source>
        <translation>des objets sont imbriqués sur plus de %1 niveaux&#xa0;: le fichier est abîmé</translation>
    </message>
    <message>
        <source>is no binary scene of PlantGL, it does not begin with !bGEOM</source>
        <translation>n’est pas une scène binaire de PlantGL, il ne commence pas par !bGEOM</translation>
    </message>
    <message>
        <source>is no version of PlantGL&apos;s scenes: the file is damaged</source>
        <translation>n’est d’aucune version des scènes de PlantGL&#xa0;: le fichier est abîmé</translation>
    </message>
    <message>
        <source>is version %1 of PlantGL&apos;s scenes, and up to 2.5 can be read: export the points as PLY</source>
        <translation>est de la version %1 des scènes de PlantGL, et on peut lire jusqu’à la 2.5&#xa0;: exportez les points en PLY</translation>
    </message>
    <message>
        <source>its line end was changed, as a transfer as text does: copy the file again as binary</source>
        <translation>sa fin de ligne a été changée, comme le fait un transfert en texte&#xa0;: copiez à nouveau le fichier en binaire</translation>
    </message>
    <message>
        <source>has reals of %1 bits, expected 32 or 64</source>
        <translation>a des réels de %1 bits, 32 ou 64 sont attendus</translation>
    </message>
    <message>
        <source>expected a comment behind #: the file is damaged</source>
        <translation>un commentaire est attendu après #&#xa0;: le fichier est abîmé</translation>
    </message>
    <message>
        <source>expected the table of types behind !: the file is damaged</source>
        <translation>la table des types est attendue après !&#xa0;: le fichier est abîmé</translation>
    </message>
    <message>
        <source>expected the scene behind !: the file is damaged</source>
        <translation>la scène est attendue après !&#xa0;: le fichier est abîmé</translation>
    </message>
    <message>
        <source>an object is of no type known: the file is damaged</source>
        <translation>un objet n’est d’aucun type connu&#xa0;: le fichier est abîmé</translation>
    </message>
    <message>
        <source>refers to an object that does not come before: the file is damaged</source>
        <translation>renvoie à un objet qui ne vient pas avant&#xa0;: le fichier est abîmé</translation>
    </message>
    <message>
        <source>has an object %1 whose size is not known in version %2: export the points alone, or as PLY</source>
        <translation>a un objet %1 dont la taille n’est pas connue dans la version %2&#xa0;: exportez les points seuls, ou en PLY</translation>
    </message>
    <message>
        <source>ends within a matrix: the file is cut short</source>
        <translation>s’arrête au milieu d’une matrice&#xa0;: le fichier est tronqué</translation>
    </message>
    <message>
        <source>1 value is not finite, or of a kind that an MTG cannot hold: left out</source>
        <translation>1 valeur n’est pas finie, ou est d’un genre qu’un MTG ne peut pas contenir&#xa0;: écartée</translation>
    </message>
    <message>
        <source>%1 values are not finite, or of a kind that an MTG cannot hold: left out</source>
        <translation>%1 valeurs ne sont pas finies, ou sont d’un genre qu’un MTG ne peut pas contenir&#xa0;: écartées</translation>
    </message>
    <message>
        <source>1 value is of vertices that were erased: left out</source>
        <translation>1 valeur est d’un sommet qui a été effacé&#xa0;: écartée</translation>
    </message>
    <message>
        <source>%1 values are of vertices that were erased: left out</source>
        <translation>%1 valeurs sont de sommets qui ont été effacés&#xa0;: écartées</translation>
    </message>
    <message>
        <source>property %1 is left out: its name cannot be that of a feature, or is taken</source>
        <translation>la propriété %1 est écartée&#xa0;: son nom ne peut pas être celui d’un attribut, ou est déjà pris</translation>
    </message>
    <message>
        <source>its values would take far more memory than the file itself: save it as .mtg with the program that wrote it</source>
        <translation>ses valeurs prendraient beaucoup plus de mémoire que le fichier lui-même&#xa0;: enregistrez-le en .mtg avec le programme qui l’a écrit</translation>
    </message>
    <message>
        <source>1 vertex lies where its parent lies, and is kept so</source>
        <translation>1 sommet est à la place de son parent, et est gardé ainsi</translation>
    </message>
    <message>
        <source>%1 vertices lie where their parents lie, and are kept so</source>
        <translation>%1 sommets sont à la place de leurs parents, et sont gardés ainsi</translation>
    </message>
    <message>
        <source>expected a field or }, found %1: export the points as PLY or .bgeom</source>
        <translation>un champ ou } est attendu, trouvé %1&#xa0;: exportez les points en PLY ou en .bgeom</translation>
    </message>
    <message>
        <source>&apos;:%1&apos; is not read: open the scene in PlantGL and save it as one file, or export the points as PLY</source>
        <translation>«&#xa0;:%1&#xa0;» n’est pas lu&#xa0;: ouvrez la scène dans PlantGL et enregistrez-la en un seul fichier, ou exportez les points en PLY</translation>
    </message>
    <message>
        <source>objects are nested deeper than %1: export the points as PLY</source>
        <translation>des objets sont imbriqués sur plus de %1 niveaux&#xa0;: exportez les points en PLY</translation>
    </message>
    <message>
        <source>expected an object, as PointSet { }, found %1: export the points as PLY or .bgeom</source>
        <translation>un objet est attendu, comme PointSet { }, trouvé %1&#xa0;: exportez les points en PLY ou en .bgeom</translation>
    </message>
    <message>
        <source>expected an object or its name, found %1: export the points as PLY or .bgeom</source>
        <translation>un objet ou son nom est attendu, trouvé %1&#xa0;: exportez les points en PLY ou en .bgeom</translation>
    </message>
    <message>
        <source>refers to %1, which does not come before: the file is damaged or not complete</source>
        <translation>renvoie à %1, qui ne vient pas avant&#xa0;: le fichier est abîmé ou incomplet</translation>
    </message>
    <message>
        <source>expected a value, found %1: export the points as PLY or .bgeom</source>
        <translation>une valeur est attendue, trouvé %1&#xa0;: exportez les points en PLY ou en .bgeom</translation>
    </message>
    <message>
        <source>expected &apos;%1&apos;, found %2: export the points as PLY or .bgeom</source>
        <translation>«&#xa0;%1&#xa0;» est attendu, trouvé %2&#xa0;: exportez les points en PLY ou en .bgeom</translation>
    </message>
    <message>
        <source>expected a number, found %1: export the points as PLY or .bgeom</source>
        <translation>un nombre est attendu, trouvé %1&#xa0;: exportez les points en PLY ou en .bgeom</translation>
    </message>
    <message>
        <source>a part of a color is not between 0 and 255: correct it</source>
        <translation>une composante d’une couleur n’est pas entre 0 et 255&#xa0;: corrigez-la</translation>
    </message>
    <message>
        <source>expected a color, found %1: export the points as PLY or .bgeom</source>
        <translation>une couleur est attendue, trouvé %1&#xa0;: exportez les points en PLY ou en .bgeom</translation>
    </message>
    <message>
        <source>ends within an object: it is cut short, copy or export it again</source>
        <translation>s’arrête au milieu d’un objet&#xa0;: il est tronqué, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>a quoted text does not end in its line: the file is damaged</source>
        <translation>un texte entre guillemets ne finit pas sur sa ligne&#xa0;: le fichier est abîmé</translation>
    </message>
    <message>
        <source>a comment that begins with (# has no end #): the file is cut short</source>
        <translation>un commentaire qui commence par (# n’a pas de fin #)&#xa0;: le fichier est tronqué</translation>
    </message>
    <message>
        <source>its tables share one another too often: save it as .mtg with the program that wrote it</source>
        <translation>ses tables se partagent trop souvent les unes les autres&#xa0;: enregistrez-le en .mtg avec le programme qui l’a écrit</translation>
    </message>
    <message>
        <source>its table %1 has a key that is no number: save it as .mtg with the program that wrote it</source>
        <translation>sa table %1 a une clé qui n’est pas un nombre&#xa0;: enregistrez-le en .mtg avec le programme qui l’a écrit</translation>
    </message>
    <message>
        <source>its table %1 is no table: save it as .mtg with the program that wrote it</source>
        <translation>sa table %1 n’en est pas une&#xa0;: enregistrez-le en .mtg avec le programme qui l’a écrit</translation>
    </message>
    <message>
        <source>it has a property whose name is no text: save it as .mtg with the program that wrote it</source>
        <translation>il a une propriété dont le nom n’est pas un texte&#xa0;: enregistrez-le en .mtg avec le programme qui l’a écrit</translation>
    </message>
    <message>
        <source>its property %1 is no table: save it as .mtg with the program that wrote it</source>
        <translation>sa propriété %1 n’est pas une table&#xa0;: enregistrez-le en .mtg avec le programme qui l’a écrit</translation>
    </message>
    <message>
        <source>is a pickle of something else than an MTG: save it as .mtg with the program that wrote it</source>
        <translation>est un pickle d’autre chose qu’un MTG&#xa0;: enregistrez-le en .mtg avec le programme qui l’a écrit</translation>
    </message>
    <message>
        <source>its state is no table: save it as .mtg with the program that wrote it</source>
        <translation>son état n’est pas une table&#xa0;: enregistrez-le en .mtg avec le programme qui l’a écrit</translation>
    </message>
    <message>
        <source>its MTG has no table _scale: save it as .mtg with the program that wrote it</source>
        <translation>son MTG n’a pas de table _scale&#xa0;: enregistrez-le en .mtg avec le programme qui l’a écrit</translation>
    </message>
    <message>
        <source>vertex %1 is among its own ancestors: the file is damaged, or was saved by a program that failed</source>
        <translation>le sommet %1 est parmi ses propres ancêtres&#xa0;: le fichier est abîmé, ou a été enregistré par un programme qui a échoué</translation>
    </message>
    <message>
        <source>vertex %1 is of scale %2: the file is damaged, or was saved by a program that failed</source>
        <translation>le sommet %1 est de l’échelle %2&#xa0;: le fichier est abîmé, ou a été enregistré par un programme qui a échoué</translation>
    </message>
    <message>
        <source>vertex %1 is attached to vertex %2 of another scale: the file is damaged, or was saved by a program that failed</source>
        <translation>le sommet %1 est attaché au sommet %2 d’une autre échelle&#xa0;: le fichier est abîmé, ou a été enregistré par un programme qui a échoué</translation>
    </message>
    <message>
        <source>vertex %1 is a part of vertex %2, which is no coarser: the file is damaged, or was saved by a program that failed</source>
        <translation>le sommet %1 est une partie du sommet %2, qui n’est pas plus grossier&#xa0;: le fichier est abîmé, ou a été enregistré par un programme qui a échoué</translation>
    </message>
    <message>
        <source>vertex %1 needs vertex %2, which is missing: the file is damaged, or was saved by a program that failed</source>
        <translation>le sommet %1 a besoin du sommet %2, qui manque&#xa0;: le fichier est abîmé, ou a été enregistré par un programme qui a échoué</translation>
    </message>
    <message>
        <source>label %1 is used on several scales, and becomes %2 on scale %3</source>
        <translation>le label %1 est utilisé à plusieurs échelles, et devient %2 à l’échelle %3</translation>
    </message>
    <message>
        <source>1 vertex has no label of letters and a number, and gets P or N</source>
        <translation>1 sommet n’a pas de label fait de lettres et d’un nombre, et reçoit P ou N</translation>
    </message>
    <message>
        <source>%1 vertices have no label of letters and a number, and get P or N</source>
        <translation>%1 sommets n’ont pas de label fait de lettres et d’un nombre, et reçoivent P ou N</translation>
    </message>
    <message>
        <source>1 edge is neither &lt; nor +, and is taken as &lt; where the parent has no other, else as +</source>
        <translation>1 arête n’est ni &lt; ni +, et est prise pour &lt; si le parent n’en a pas d’autre, sinon pour +</translation>
    </message>
    <message>
        <source>%1 edges are neither &lt; nor +, and are taken as &lt; where the parent has no other, else as +</source>
        <translation>%1 arêtes ne sont ni &lt; ni +, et sont prises pour &lt; là où le parent n’en a pas d’autre, sinon pour +</translation>
    </message>
    <message>
        <source>1 vertex has more than one successor, and is kept so</source>
        <translation>1 sommet a plus d’un successeur, et est gardé ainsi</translation>
    </message>
    <message>
        <source>%1 vertices have more than one successor, and are kept so</source>
        <translation>%1 sommets ont plus d’un successeur, et sont gardés ainsi</translation>
    </message>
    <message>
        <source>holds no vertices</source>
        <translation>ne contient pas de sommets</translation>
    </message>
    <message>
        <source>opcode %1 is not plain data, and this file may be meant to do harm: it is not read. If you trust it, save it as .mtg with the program that wrote it</source>
        <translation>l’opcode %1 n’est pas une simple donnée, et ce fichier peut vouloir nuire&#xa0;: il n’est pas lu. Si vous lui faites confiance, enregistrez-le en .mtg avec le programme qui l’a écrit</translation>
    </message>
    <message>
        <source>opcode %1 finds no mark: the file is damaged</source>
        <translation>l’opcode %1 ne trouve pas de marque&#xa0;: le fichier est abîmé</translation>
    </message>
    <message>
        <source>opcode %1 finds nothing to work on: the file is damaged</source>
        <translation>l’opcode %1 ne trouve rien à traiter&#xa0;: le fichier est abîmé</translation>
    </message>
    <message>
        <source>opcode %1 comes after more values than can be counted</source>
        <translation>l’opcode %1 vient après plus de valeurs qu’on ne peut en compter</translation>
    </message>
    <message>
        <source>opcode %1 has a text of negative length</source>
        <translation>l’opcode %1 a un texte de longueur négative</translation>
    </message>
    <message>
        <source>opcode %1 has %2, expected a number</source>
        <translation>l’opcode %1 a %2, un nombre est attendu</translation>
    </message>
    <message>
        <source>opcode %1 has an integer of more than 64 bits</source>
        <translation>l’opcode %1 a un entier de plus de 64 bits</translation>
    </message>
    <message>
        <source>opcode %1 has %2, expected an integer of up to 64 bits</source>
        <translation>l’opcode %1 a %2, un entier de 64 bits au plus est attendu</translation>
    </message>
    <message>
        <source>opcode %1 has %2, expected a text in quotes</source>
        <translation>l’opcode %1 a %2, un texte entre guillemets est attendu</translation>
    </message>
    <message>
        <source>opcode %1 does not find a list or set to add to: the file is damaged</source>
        <translation>l’opcode %1 ne trouve pas de liste ou d’ensemble à compléter&#xa0;: le fichier est abîmé</translation>
    </message>
    <message>
        <source>opcode %1 does not find a dict to add to: the file is damaged</source>
        <translation>l’opcode %1 ne trouve pas de dictionnaire à compléter&#xa0;: le fichier est abîmé</translation>
    </message>
    <message>
        <source>opcode %1 has a key without a value: the file is damaged</source>
        <translation>l’opcode %1 a une clé sans valeur&#xa0;: le fichier est abîmé</translation>
    </message>
    <message>
        <source>opcode %1 asks for protocol %2, and 0 to %3 can be read: save it with an older protocol</source>
        <translation>l’opcode %1 demande le protocole %2, et on peut lire de 0 à %3&#xa0;: enregistrez-le avec un protocole plus ancien</translation>
    </message>
    <message>
        <source>opcode %1 has %2, expected the number of a memo</source>
        <translation>l’opcode %1 a %2, le numéro d’un mémo est attendu</translation>
    </message>
    <message>
        <source>opcode %1 asks for memo %2, which was never set: the file is damaged</source>
        <translation>l’opcode %1 demande le mémo %2, qui n’a jamais été rempli&#xa0;: le fichier est abîmé</translation>
    </message>
    <message>
        <source>opcode %1 does not find the text of a module: the file is damaged</source>
        <translation>l’opcode %1 ne trouve pas le texte d’un module&#xa0;: le fichier est abîmé</translation>
    </message>
    <message>
        <source>opcode %1 does not find the text of a name: the file is damaged</source>
        <translation>l’opcode %1 ne trouve pas le texte d’un nom&#xa0;: le fichier est abîmé</translation>
    </message>
    <message>
        <source>opcode %1 asks for %2 of %3, which a plant does not need, and this file may be meant to do harm: it is not read. If you trust it, save it as .mtg with the program that wrote it</source>
        <translation>l’opcode %1 demande %2 de %3, dont une plante n’a pas besoin, et ce fichier peut vouloir nuire&#xa0;: il n’est pas lu. Si vous lui faites confiance, enregistrez-le en .mtg avec le programme qui l’a écrit</translation>
    </message>
    <message>
        <source>opcode %1 does not find a class: the file is damaged</source>
        <translation>l’opcode %1 ne trouve pas de classe&#xa0;: le fichier est abîmé</translation>
    </message>
    <message>
        <source>opcode %1 does not find a tuple: the file is damaged</source>
        <translation>l’opcode %1 ne trouve pas de tuple&#xa0;: le fichier est abîmé</translation>
    </message>
    <message>
        <source>opcode %1 does not find an object: the file is damaged</source>
        <translation>l’opcode %1 ne trouve pas d’objet&#xa0;: le fichier est abîmé</translation>
    </message>
    <message>
        <source>opcode %1 sets the state of an object twice: the file is damaged</source>
        <translation>l’opcode %1 fixe deux fois l’état d’un objet&#xa0;: le fichier est abîmé</translation>
    </message>
    <message>
        <source>repeats its %1 points more than %2 times: export the points alone, or as PLY</source>
        <translation>répète ses %1 points plus de %2 fois&#xa0;: exportez les points seuls, ou en PLY</translation>
    </message>
    <message>
        <source>holds %1 points, more than can be worked on at once: thin or split it</source>
        <translation>contient %1 points, plus qu’on ne peut en traiter à la fois&#xa0;: éclaircissez-le ou divisez-le</translation>
    </message>
    <message>
        <source>objects that are no point sets are passed over: %1</source>
        <translation>les objets qui ne sont pas des ensembles de points sont laissés de côté&#xa0;: %1</translation>
    </message>
    <message>
        <source>1 point in objects that the scene bends, or turns unclearly, left out</source>
        <translation>1 point dans des objets que la scène courbe, ou tourne de façon peu claire, écarté</translation>
    </message>
    <message>
        <source>%1 points in objects that the scene bends, or turns unclearly, left out</source>
        <translation>%1 points dans des objets que la scène courbe, ou tourne de façon peu claire, écartés</translation>
    </message>
    <message>
        <source>1 point set has another number of colors than of points, and loses them</source>
        <translation>1 ensemble de points n’a pas autant de couleurs que de points, et les perd</translation>
    </message>
    <message>
        <source>%1 point sets have another number of colors than of points, and lose them</source>
        <translation>%1 ensembles de points n’ont pas autant de couleurs que de points, et les perdent</translation>
    </message>
    <message>
        <source>its octree (COPC) does not fit its points, so no part of them is found: the file is damaged, copy or export it again</source>
        <translation>son octree (COPC) ne correspond pas à ses points, on ne peut donc pas en trouver une partie&#xa0;: le fichier est endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>promises %1 points of hardly any bits, as of no scan: the file is damaged, export it again</source>
        <translation>annonce %1 points de presque aucun bit, comme aucun scan n’en a&#xa0;: le fichier est endommagé, exportez-le à nouveau</translation>
    </message>
    <message>
        <source>%1 of %2 points are marked as having no position and are left out</source>
        <translation>%1 points sur %2 sont marqués comme n’ayant pas de position et sont écartés</translation>
    </message>
    <message>
        <source>its points have neither cartesianX, Y and Z nor sphericalRange, Azimuth and Elevation: export them with Cartesian coordinates</source>
        <translation>ses points n’ont ni cartesianX, Y et Z ni sphericalRange, Azimuth et Elevation&#xa0;: exportez-les avec des coordonnées cartésiennes</translation>
    </message>
    <message>
        <source>expected an integer of 64 bits as %1, found %2</source>
        <translation>un entier de 64 bits est attendu pour %1, mais on trouve %2</translation>
    </message>
    <message>
        <source>the maximum of %1 is below its minimum: the file is damaged, export it again</source>
        <translation>le maximum de %1 est inférieur à son minimum&#xa0;: le fichier est endommagé, exportez-le à nouveau</translation>
    </message>
    <message>
        <source>the field %1 is of type %2, expected Float, Integer or ScaledInteger</source>
        <translation>le champ %1 est de type %2, alors que Float, Integer ou ScaledInteger est attendu</translation>
    </message>
    <message>
        <source>a packet of %1 bytes starts here, but only %2 follow: the file is damaged, copy or export it again</source>
        <translation>un paquet de %1 octets commence ici, mais seulement %2 suivent&#xa0;: le fichier est endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>expected a packet of type 0 to 2 within %1 bytes, found type %2 of %3 bytes: the file is damaged, copy or export it again</source>
        <translation>un paquet de type 0 à 2 est attendu dans les %1 octets qui restent, mais on trouve le type %2 de %3 octets&#xa0;: le fichier est endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>says that a section of points starts at byte %1, where none can be: the file is damaged, copy or export it again</source>
        <translation>dit qu’une section de points commence à l’octet %1, où il ne peut pas y en avoir&#xa0;: le fichier est endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>the header of points of %1 bytes starts here, but only %2 follow: the file is damaged, copy or export it again</source>
        <translation>l’en-tête des points, de %1 octets, commence ici, mais seulement %2 suivent&#xa0;: le fichier est endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>expected a section of points, which begins with 1, found %1: the file is damaged, copy or export it again</source>
        <translation>une section de points, qui commence par 1, est attendue, mais on trouve %1&#xa0;: le fichier est endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>a section of points of %1 bytes starts here, but only %2 follow: the file is damaged, copy or export it again</source>
        <translation>une section de points de %1 octets commence ici, mais seulement %2 suivent&#xa0;: le fichier est endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>says that the first packet of points starts at byte %1, where none can be: the file is damaged, copy or export it again</source>
        <translation>dit que le premier paquet de points commence à l’octet %1, où il ne peut pas y en avoir&#xa0;: le fichier est endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>the first packet of points is not within their section: the file is damaged, copy or export it again</source>
        <translation>le premier paquet de points n’est pas dans leur section&#xa0;: le fichier est endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>two scans have the same section of points: the file is damaged, export it again</source>
        <translation>deux scans ont la même section de points&#xa0;: le fichier est endommagé, exportez-le à nouveau</translation>
    </message>
    <message>
        <source>a packet of data ends within its header: the file is damaged, copy or export it again</source>
        <translation>un paquet de données s’arrête dans son en-tête&#xa0;: le fichier est endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>a packet of data has %1 streams, but its points have %2 fields: the file is damaged, copy or export it again</source>
        <translation>un paquet de données a %1 flux, mais ses points ont %2 champs&#xa0;: le fichier est endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>the streams of a packet of data are longer than it is: the file is damaged, copy or export it again</source>
        <translation>les flux d’un paquet de données sont plus longs que lui&#xa0;: le fichier est endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>the packets end here, with %1 of %2 points: the file is damaged, copy or export it again</source>
        <translation>les paquets s’arrêtent ici, avec %1 points sur %2&#xa0;: le fichier est endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>page %1 of %2 does not fit its checksum: the file is damaged, copy or export it again</source>
        <translation>la page %1 sur %2 ne correspond pas à sa somme de contrôle&#xa0;: le fichier est endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>is no E57 file, it does not begin with %1</source>
        <translation>n’est pas un fichier E57, il ne commence pas par %1</translation>
    </message>
    <message>
        <source>ends within its header: the file is cut short, copy or export it again</source>
        <translation>s’arrête dans son en-tête&#xa0;: le fichier est tronqué, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>is E57 %1, and version 1 can be read: export it as that</source>
        <translation>est en E57 %1, et seule la version 1 peut être lue&#xa0;: exportez-le dans celle-ci</translation>
    </message>
    <message>
        <source>has pages of %1 bytes, not of %2: the header is damaged, copy or export it again</source>
        <translation>a des pages de %1 octets, et non de %2&#xa0;: l’en-tête est endommagé, copiez le fichier ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>its header promises %1 bytes, but it has %2: the file is cut short, copy or export it again</source>
        <translation>son en-tête annonce %1 octets, mais il en a %2&#xa0;: le fichier est tronqué, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>says it has %1 bytes, which are no whole pages: the header is damaged, copy or export it again</source>
        <translation>dit avoir %1 octets, ce qui ne fait pas des pages entières&#xa0;: l’en-tête est endommagé, copiez le fichier ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>says that the XML of %1 bytes starts at byte %2, where none can be: the file is damaged, copy or export it again</source>
        <translation>dit que le XML de %1 octets commence à l’octet %2, où il ne peut pas y en avoir&#xa0;: le fichier est endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>expected a whole number as %1, found %2</source>
        <translation>un nombre entier est attendu pour %1, mais on trouve %2</translation>
    </message>
    <message>
        <source>the points are packed by %1, which E57 1.0 does not know: export them again, as E57 1.0</source>
        <translation>les points sont compressés par %1, qu’E57 1.0 ne connaît pas&#xa0;: exportez-les à nouveau, en E57 1.0</translation>
    </message>
    <message>
        <source>the rotation of station %1 is no unit quaternion: its points are moved, not turned</source>
        <translation>la rotation de la station %1 n’est pas un quaternion unitaire&#xa0;: ses points sont déplacés, mais pas tournés</translation>
    </message>
    <message>
        <source>holds no points, a line each of at least 3 numbers</source>
        <translation>ne contient pas de points, c’est-à-dire des lignes d’au moins 3 nombres</translation>
    </message>
    <message>
        <source>has 1 column, and a point has x, y and z: export it again with all three</source>
        <translation>a 1 colonne, alors qu’un point a x, y et z&#xa0;: exportez-le à nouveau avec les trois</translation>
    </message>
    <message>
        <source>has %1 columns, and a point has x, y and z: export it again with all three</source>
        <translation>a %1 colonnes, alors qu’un point a x, y et z&#xa0;: exportez-le à nouveau avec les trois</translation>
    </message>
    <message>
        <source>is compressed (LAZ), not LAS: name it so, as a.laz</source>
        <translation>est compressé (LAZ), ce n’est pas du LAS&#xa0;: nommez-le en conséquence, par exemple a.laz</translation>
    </message>
    <message>
        <source>has points of format %1, which LAS 1.4 does not define: convert it to one of 0 to 10</source>
        <translation>a des points au format %1, que LAS 1.4 ne définit pas&#xa0;: convertissez-le en un format de 0 à 10</translation>
    </message>
    <message>
        <source>says its points of format %1 have %2 bytes, fewer than the %3 of this format: the header is damaged, export it again</source>
        <translation>dit que ses points au format %1 ont %2 octets, moins que les %3 de ce format&#xa0;: l’en-tête est endommagé, exportez le fichier à nouveau</translation>
    </message>
    <message>
        <source>says its points start at byte %1 of %2: the file is cut short or damaged, copy or export it again</source>
        <translation>dit que ses points commencent à l’octet %1 sur %2&#xa0;: le fichier est tronqué ou endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>is no LAS file, it does not begin with LASF</source>
        <translation>n’est pas un fichier LAS, il ne commence pas par LASF</translation>
    </message>
    <message>
        <source>is LAS %1, and versions 1.0 to 1.4 can be read: convert it to 1.4</source>
        <translation>est en LAS %1, et seules les versions 1.0 à 1.4 peuvent être lues&#xa0;: convertissez-le en 1.4</translation>
    </message>
    <message>
        <source>%1 of %2 points are flagged as withheld and are left out</source>
        <translation>%1 points sur %2 sont marqués comme retirés («&#xa0;withheld&#xa0;») et sont écartés</translation>
    </message>
    <message>
        <source>its header promises %1 points, but only %2 bytes follow: the file is cut short or damaged, copy or export it again</source>
        <translation>son en-tête annonce %1 points, mais seulement %2 octets suivent&#xa0;: le fichier est tronqué ou endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>its points from byte %1 on cannot be unpacked: the file is damaged, copy or export it again</source>
        <translation>ses points à partir de l’octet %1 ne peuvent pas être décompressés&#xa0;: le fichier est endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>is LAS, not compressed (LAZ): name it so, as a.las</source>
        <translation>est en LAS, non compressé (LAZ)&#xa0;: nommez-le en conséquence, par exemple a.las</translation>
    </message>
    <message>
        <source>ends within its record of LASzip: the file is cut short or damaged, copy or export it again</source>
        <translation>s’arrête dans son enregistrement de LASzip&#xa0;: le fichier est tronqué ou endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>says of what its points consist, but not as points of format %1 with %2 bytes do: the file is cut short or damaged, copy or export it again</source>
        <translation>dit de quoi ses points se composent, mais autrement que des points au format %1 de %2 octets&#xa0;: le fichier est tronqué ou endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>is compressed by a method of number %1, and 1 to 3 can be read: unpack it to LAS, as by &apos;laszip -i %2 -o unpacked.las&apos;</source>
        <translation>est compressé par une méthode de numéro %1, et seules 1 à 3 peuvent être lues&#xa0;: décompressez-le en LAS, par exemple avec «&#xa0;laszip -i %2 -o unpacked.las&#xa0;»</translation>
    </message>
    <message>
        <source>is compressed by a coder of number %1, and 0 can be read: unpack it to LAS, as by &apos;laszip -i %2 -o unpacked.las&apos;</source>
        <translation>est compressé par un codeur de numéro %1, et seul 0 peut être lu&#xa0;: décompressez-le en LAS, par exemple avec «&#xa0;laszip -i %2 -o unpacked.las&#xa0;»</translation>
    </message>
    <message>
        <source>has parts of points (item %1) that are compressed in version %2, which cannot be read: unpack it to LAS, as by &apos;laszip -i %3 -o unpacked.las&apos;</source>
        <translation>a des parties de points (élément %1) compressées dans la version %2, qui ne peut pas être lue&#xa0;: décompressez-le en LAS, par exemple avec «&#xa0;laszip -i %3 -o unpacked.las&#xa0;»</translation>
    </message>
    <message>
        <source>says its points of format %1 are compressed by method %2, which is for other formats: the file is cut short or damaged, copy or export it again</source>
        <translation>dit que ses points au format %1 sont compressés par la méthode %2, qui est pour d’autres formats&#xa0;: le fichier est tronqué ou endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>ends before its first point: the file is cut short or damaged, copy or export it again</source>
        <translation>s’arrête avant son premier point&#xa0;: le fichier est tronqué ou endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>has no table of its chunks of points where it should be: the file is cut short or damaged, copy or export it again</source>
        <translation>n’a pas de table de ses blocs de points là où elle devrait être&#xa0;: le fichier est tronqué ou endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>has a table of chunks that does not fit its %1 points: the file is cut short or damaged, copy or export it again</source>
        <translation>a une table de blocs qui ne correspond pas à ses %1 points&#xa0;: le fichier est tronqué ou endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>has no record of LASzip on how its points are compressed: the file is cut short or damaged, copy or export it again</source>
        <translation>n’a pas d’enregistrement de LASzip disant comment ses points sont compressés&#xa0;: le fichier est tronqué ou endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>has no field &apos;%1&apos;: export it with x, y and z</source>
        <translation>n’a pas de champ «&#xa0;%1&#xa0;»&#xa0;: exportez-le avec x, y et z</translation>
    </message>
    <message>
        <source>expected a number as value %1, found the end of the line</source>
        <translation>un nombre est attendu comme valeur %1, mais on trouve la fin de la ligne</translation>
    </message>
    <message>
        <source>expected a number as value %1, found %2</source>
        <translation>un nombre est attendu comme valeur %1, mais on trouve %2</translation>
    </message>
    <message>
        <source>ends after %1 of %2 points: it is cut short, copy or export it again</source>
        <translation>s’arrête après %1 points sur %2&#xa0;: il est tronqué, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>its %1 bytes of compressed data would unpack to %2 bytes of %3 points, as of no scan: export it again, not compressed</source>
        <translation>ses %1 octets de données compressées se décompresseraient en %2 octets de %3 points, comme aucun scan n’en a&#xa0;: exportez-le à nouveau, sans compression</translation>
    </message>
    <message>
        <source>ends before its data: it is cut short</source>
        <translation>s’arrête avant ses données&#xa0;: il est tronqué</translation>
    </message>
    <message>
        <source>its header promises %1 bytes of compressed data, but only %2 follow: the file is cut short, copy or export it again</source>
        <translation>son en-tête annonce %1 octets de données compressées, mais seulement %2 suivent&#xa0;: le fichier est tronqué, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>its compressed data is damaged: copy or export it again</source>
        <translation>ses données compressées sont endommagées&#xa0;: copiez le fichier ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>expected a whole number, found %1</source>
        <translation>un nombre entier est attendu, mais on trouve %1</translation>
    </message>
    <message>
        <source>a field of type %1 cannot have 1 byte</source>
        <translation>un champ de type %1 ne peut pas avoir 1 octet</translation>
    </message>
    <message>
        <source>a field of type %1 cannot have %2 bytes</source>
        <translation>un champ de type %1 ne peut pas avoir %2 octets</translation>
    </message>
    <message>
        <source>its header has no line %1</source>
        <translation>son en-tête n’a pas de ligne %1</translation>
    </message>
    <message>
        <source>expected %1 values, one per field, found %2</source>
        <translation>%1 valeurs sont attendues, une par champ, mais on en trouve %2</translation>
    </message>
    <message>
        <source>a field cannot have %1 values</source>
        <translation>un champ ne peut pas avoir %1 valeurs</translation>
    </message>
    <message>
        <source>expected a whole number</source>
        <translation>un nombre entier est attendu</translation>
    </message>
    <message>
        <source>WIDTH times HEIGHT is beyond any file</source>
        <translation>WIDTH fois HEIGHT dépasse tout fichier possible</translation>
    </message>
    <message>
        <source>data of kind %1 is unknown: expected ascii, binary or binary_compressed</source>
        <translation>les données de type %1 sont inconnues&#xa0;: ascii, binary ou binary_compressed est attendu</translation>
    </message>
    <message>
        <source>its header has no line DATA: it is no PCD file, or is cut short</source>
        <translation>son en-tête n’a pas de ligne DATA&#xa0;: ce n’est pas un fichier PCD, ou il est tronqué</translation>
    </message>
    <message>
        <source>its element &apos;vertex&apos; has no property &apos;%1&apos;: export it with x, y and z</source>
        <translation>son élément «&#xa0;vertex&#xa0;» n’a pas de propriété «&#xa0;%1&#xa0;»&#xa0;: exportez-le avec x, y et z</translation>
    </message>
    <message>
        <source>ends within %1 %2 of %3: the file is cut short or damaged, copy or export it again</source>
        <translation>s’arrête dans %1 %2 sur %3&#xa0;: le fichier est tronqué ou endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>expected %1 numbers, found %2</source>
        <translation>%1 nombres sont attendus, mais on en trouve %2</translation>
    </message>
    <message>
        <source>expected a number, found %1</source>
        <translation>un nombre est attendu, mais on trouve %1</translation>
    </message>
    <message>
        <source>is a mesh: 1 face left out, its corners are taken as points</source>
        <translation>est un maillage&#xa0;: 1&#xa0;face est écartée, ses sommets sont pris comme points</translation>
    </message>
    <message>
        <source>is a mesh: %1 faces left out, its corners are taken as points</source>
        <translation>est un maillage&#xa0;: %1&#xa0;faces sont écartées, leurs sommets sont pris comme points</translation>
    </message>
    <message>
        <source>has no element &apos;vertex&apos;, so no points</source>
        <translation>n’a pas d’élément «&#xa0;vertex&#xa0;», donc pas de points</translation>
    </message>
    <message>
        <source>%1 is no type of PLY: expected one as &apos;float&apos; or &apos;uchar&apos;</source>
        <translation>%1 n’est pas un type de PLY&#xa0;: un type comme «&#xa0;float&#xa0;» ou «&#xa0;uchar&#xa0;» est attendu</translation>
    </message>
    <message>
        <source>the format %1 is unknown: expected ascii, binary_little_endian or binary_big_endian</source>
        <translation>le format %1 est inconnu&#xa0;: ascii, binary_little_endian ou binary_big_endian est attendu</translation>
    </message>
    <message>
        <source>expected a name and a count after &apos;element&apos;, found %1 for the count</source>
        <translation>un nom et un nombre sont attendus après «&#xa0;element&#xa0;», mais on trouve %1 comme nombre</translation>
    </message>
    <message>
        <source>the length of a list must be of an integer type</source>
        <translation>la longueur d’une liste doit être de type entier</translation>
    </message>
    <message>
        <source>a property has no name</source>
        <translation>une propriété n’a pas de nom</translation>
    </message>
    <message>
        <source>is no PLY file, its first line is not &apos;ply&apos;</source>
        <translation>n’est pas un fichier PLY, sa première ligne n’est pas «&#xa0;ply&#xa0;»</translation>
    </message>
    <message>
        <source>a property stands before any element</source>
        <translation>une propriété précède tout élément</translation>
    </message>
    <message>
        <source>the header has no line &apos;format&apos;</source>
        <translation>l’en-tête n’a pas de ligne «&#xa0;format&#xa0;»</translation>
    </message>
    <message>
        <source>%1 is unknown in the header of a PLY file</source>
        <translation>%1 est inconnu dans l’en-tête d’un fichier PLY</translation>
    </message>
    <message>
        <source>has no line &apos;end_header&apos;: it is cut short, copy or export it again</source>
        <translation>n’a pas de ligne «&#xa0;end_header&#xa0;»&#xa0;: il est tronqué, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>its header promises %1 points of at least %2 bytes, but only %3 bytes follow: the file is cut short or damaged, copy or export it again</source>
        <translation>son en-tête annonce %1 points d’au moins %2 octets, mais seulement %3 octets suivent&#xa0;: le fichier est tronqué ou endommagé, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>became shorter while it was read: wait until it is complete, and try again</source>
        <translation>a raccourci pendant sa lecture&#xa0;: attendez qu’il soit complet, et réessayez</translation>
    </message>
    <message>
        <source>expected a whole number of columns or rows, found %1</source>
        <translation>un nombre entier de colonnes ou de rangées est attendu, mais on trouve %1</translation>
    </message>
    <message>
        <source>ends within the header of a block: it is cut short, copy or export it again</source>
        <translation>s’arrête dans l’en-tête d’un bloc&#xa0;: il est tronqué, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>the matrix that ends here makes all points flat: the header is damaged, export it again</source>
        <translation>la matrice qui se termine ici aplatit tous les points&#xa0;: l’en-tête est endommagé, exportez le fichier à nouveau</translation>
    </message>
    <message>
        <source>ends after %1 of %2 points of its last block: it is cut short, copy or export it again</source>
        <translation>s’arrête après %1 points sur %2 de son dernier bloc&#xa0;: il est tronqué, copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>expected x y z, intensity and red green blue, 4 or 7 numbers, found %1</source>
        <translation>x y z, intensité et rouge vert bleu, soit 4 ou 7 nombres, sont attendus, mais on en trouve %1</translation>
    </message>
    <message>
        <source>expected %1 numbers as in the lines before, found %2</source>
        <translation>%1 nombres sont attendus comme dans les lignes précédentes, mais on en trouve %2</translation>
    </message>
    <message>
        <source>%1 of %2 points have no return (0 0 0) and are left out</source>
        <translation>%1 points sur %2 n’ont pas de retour (0 0 0) et sont écartés</translation>
    </message>
    <message>
        <source>expected the header of a block of PTX, ten lines of numbers</source>
        <translation>l’en-tête d’un bloc PTX, dix lignes de nombres, est attendu</translation>
    </message>
    <message>
        <source>holds %1 stations, which are joined into one set of points</source>
        <translation>contient %1 stations, qui sont réunies en un seul ensemble de points</translation>
    </message>
    <message>
        <source>no colors in %1 of %2 stations: points there are black</source>
        <translation>pas de couleurs dans %1 stations sur %2&#xa0;: leurs points sont noirs</translation>
    </message>
    <message>
        <source>no intensities in %1 of %2 stations: those of points there are 0</source>
        <translation>pas d’intensités dans %1 stations sur %2&#xa0;: celles de leurs points valent 0</translation>
    </message>
    <message>
        <source>%1 of %2 columns are left out; a first line as &apos;x y z intensity r g b&apos; names columns</source>
        <translation>%1 colonnes sur %2 sont écartées&#xa0;; une première ligne comme «&#xa0;x y z intensity r g b&#xa0;» nomme les colonnes</translation>
    </message>
    <message>
        <source>promises %1 points, but lists %2</source>
        <translation>annonce %1 points, mais en liste %2</translation>
    </message>
    <message>
        <source>expected 3 numbers, found text, and no points follow</source>
        <translation>3 nombres sont attendus, mais on trouve du texte, et aucun point ne suit</translation>
    </message>
    <message>
        <source>is no plain text, though its name says so: export it as text, or give it the extension of its format</source>
        <translation>n’est pas du texte brut, bien que son nom le dise&#xa0;: exportez-le en texte, ou donnez-lui l’extension de son format</translation>
    </message>
    <message>
        <source>1 column is named, but its first line of points has %2: name each, with - for those to leave out</source>
        <translation>1 colonne est nommée, mais sa première ligne de points en a %2&#xa0;: nommez chacune, avec - pour celles à écarter</translation>
    </message>
    <message>
        <source>%1 columns are named, but its first line of points has %2: name each, with - for those to leave out</source>
        <translation>%1 colonnes sont nommées, mais sa première ligne de points en a %2&#xa0;: nommez chacune, avec - pour celles à écarter</translation>
    </message>
    <message>
        <source>has a short element of more than 4 bytes: it is damaged</source>
        <translation>a un élément court de plus de 4 octets&#xa0;: il est abîmé</translation>
    </message>
    <message>
        <source>gives no size of the names of its fields: it is damaged</source>
        <translation>ne donne pas la taille des noms de ses champs&#xa0;: il est abîmé</translation>
    </message>
    <message>
        <source>has names of fields that are cut short: it is damaged</source>
        <translation>a des noms de champs qui sont tronqués&#xa0;: il est abîmé</translation>
    </message>
    <message>
        <source>has a field that is no matrix: it is damaged</source>
        <translation>a un champ qui n’est pas une matrice&#xa0;: il est abîmé</translation>
    </message>
    <message>
        <source>has numbers of a type that is not known: it is damaged</source>
        <translation>a des nombres d’un type inconnu&#xa0;: il est abîmé</translation>
    </message>
    <message>
        <source>has 1 number, expected %2 x %3: it is damaged</source>
        <translation>a 1 nombre, %2 x %3 sont attendus&#xa0;: il est abîmé</translation>
    </message>
    <message>
        <source>has %1 numbers, expected %2 x %3: it is damaged</source>
        <translation>a %1 nombres, %2 x %3 sont attendus&#xa0;: il est abîmé</translation>
    </message>
    <message>
        <source>has %1 numbers in one array, more than any model: at most %2 are read</source>
        <translation>a %1 nombres dans un seul tableau, plus qu’aucun modèle&#xa0;: %2 au plus sont lus</translation>
    </message>
    <message>
        <source>has a variable without a size: it is damaged</source>
        <translation>a une variable sans taille&#xa0;: il est abîmé</translation>
    </message>
    <message>
        <source>has a variable of too many elements to be true: it is damaged</source>
        <translation>a une variable de trop d’éléments pour être vraie&#xa0;: il est abîmé</translation>
    </message>
    <message>
        <source>has a variable without flags: it is damaged</source>
        <translation>a une variable sans indicateurs&#xa0;: il est abîmé</translation>
    </message>
    <message>
        <source>ends within its header: the file is cut short, copy it again</source>
        <translation>s’arrête au milieu de son en-tête&#xa0;: le fichier est tronqué, copiez-le à nouveau</translation>
    </message>
    <message>
        <source>is a MAT file of version 7.3, and 5 to 7 can be read: save it by save(name, &apos;-v7&apos;, ...)</source>
        <translation>est un fichier MAT de version 7.3, et on peut lire de 5 à 7&#xa0;: enregistrez-le par save(name, &apos;-v7&apos;, ...)</translation>
    </message>
    <message>
        <source>is no MAT file of MATLAB 5 to 7: save it again by save(name, &apos;-v7&apos;, ...)</source>
        <translation>n’est pas un fichier MAT de MATLAB 5 à 7&#xa0;: enregistrez-le à nouveau par save(name, &apos;-v7&apos;, ...)</translation>
    </message>
    <message>
        <source>has a variable that unpacks to over 128 MiB, as of no model: save the model alone</source>
        <translation>a une variable qui décompressée dépasse 128 Mio, comme celle d’aucun modèle&#xa0;: enregistrez le modèle seul</translation>
    </message>
    <message>
        <source>has a variable that cannot be unpacked: the file is damaged, save it again</source>
        <translation>a une variable qui ne peut pas être décompressée&#xa0;: le fichier est abîmé, enregistrez-le à nouveau</translation>
    </message>
    <message>
        <source>unpacks to over 1 GiB up to here, as of no model: save the model alone</source>
        <translation>décompressé dépasse 1 Gio jusqu’ici, comme aucun modèle&#xa0;: enregistrez le modèle seul</translation>
    </message>
    <message>
        <source>holds no cylinders: export it again</source>
        <translation>ne contient pas de cylindres&#xa0;: exportez-le à nouveau</translation>
    </message>
    <message>
        <source>cylinder %1 has a value that is not finite</source>
        <translation>le cylindre %1 a une valeur qui n’est pas finie</translation>
    </message>
    <message>
        <source>cylinder %1 has a negative radius</source>
        <translation>le cylindre %1 a un rayon négatif</translation>
    </message>
    <message>
        <source>cylinder %1 is attached to cylinder %2, and there are %3: the table is cut short or damaged</source>
        <translation>le cylindre %1 est attaché au cylindre %2, et il y en a %3&#xa0;: le tableau est tronqué ou abîmé</translation>
    </message>
    <message>
        <source>cylinder %1 is among its own ancestors: correct its parent</source>
        <translation>le cylindre %1 est parmi ses propres ancêtres&#xa0;: corrigez son parent</translation>
    </message>
    <message>
        <source>does not say which cylinder continues another: the first in the file is taken</source>
        <translation>ne dit pas quel cylindre en continue un autre&#xa0;: le premier dans le fichier est pris</translation>
    </message>
    <message>
        <source>1 cylinder begins farther than its radius from the end of the one that bears it, by up to %2; the edge begins at that end nevertheless</source>
        <translation>1 cylindre commence à plus de son rayon de la fin de celui qui le porte, à %2&#xa0;; l’arête commence tout de même à cette fin</translation>
    </message>
    <message>
        <source>%1 cylinders begin farther than its radius from the end of the one that bears it, by up to %2; the edge begins at that end nevertheless</source>
        <translation>%1 cylindres commencent à plus d’un rayon de la fin de celui qui les porte, jusqu’à %2&#xa0;; l’arête commence tout de même à cette fin</translation>
    </message>
    <message>
        <source>1 extension is a cylinder that is not attached to the one it should extend, and is passed over</source>
        <translation>1 prolongement est un cylindre qui n’est pas attaché à celui qu’il devrait prolonger, et est laissé de côté</translation>
    </message>
    <message>
        <source>%1 extensions are cylinders that are not attached to the ones they should extend, and are passed over</source>
        <translation>%1 prolongements sont des cylindres qui ne sont pas attachés à ceux qu’ils devraient prolonger, et sont laissés de côté</translation>
    </message>
    <message>
        <source>cylinder %1 has a negative length</source>
        <translation>le cylindre %1 a une longueur négative</translation>
    </message>
    <message>
        <source>cylinder %1 has an axis that is not of length 1: the file is damaged, save it again</source>
        <translation>le cylindre %1 a un axe qui n’est pas de longueur 1&#xa0;: le fichier est abîmé, enregistrez-le à nouveau</translation>
    </message>
    <message>
        <source>cylinder %1 has no whole number as %2</source>
        <translation>le cylindre %1 n’a pas de nombre entier pour %2</translation>
    </message>
    <message>
        <source>field &apos;%1&apos; of its cylinders is missing: save the whole model of TreeQSM</source>
        <translation>le champ «&#xa0;%1&#xa0;» de ses cylindres manque&#xa0;: enregistrez tout le modèle de TreeQSM</translation>
    </message>
    <message>
        <source>field &apos;%1&apos; of its cylinders is no table of numbers</source>
        <translation>le champ «&#xa0;%1&#xa0;» de ses cylindres n’est pas un tableau de nombres</translation>
    </message>
    <message>
        <source>field &apos;%1&apos; of its cylinders has %2 x %3 values, expected %4 x %5</source>
        <translation>le champ «&#xa0;%1&#xa0;» de ses cylindres a %2 x %3 valeurs, %4 x %5 sont attendues</translation>
    </message>
    <message>
        <source>holds %1 models, of which the first is read</source>
        <translation>contient %1 modèles, dont le premier est lu</translation>
    </message>
    <message>
        <source>holds no model of TreeQSM: expected a structure with a field &apos;cylinder&apos;</source>
        <translation>ne contient pas de modèle de TreeQSM&#xa0;: une structure avec un champ «&#xa0;cylinder&#xa0;» est attendue</translation>
    </message>
    <message>
        <source>expected %1 columns, found %2</source>
        <translation>%1 colonnes sont attendues, trouvé %2</translation>
    </message>
    <message>
        <source>expected a number in column %1, found %2</source>
        <translation>un nombre est attendu dans la colonne %1, trouvé %2</translation>
    </message>
    <message>
        <source>expected a whole number in column %1, found %2</source>
        <translation>un nombre entier est attendu dans la colonne %1, trouvé %2</translation>
    </message>
    <message>
        <source>the length is negative</source>
        <translation>la longueur est négative</translation>
    </message>
    <message>
        <source>the axis has no direction</source>
        <translation>l’axe n’a pas de direction</translation>
    </message>
    <message>
        <source>node %1 has a position or radius that is not finite: move or remove it</source>
        <translation>le nœud %1 a une position ou un rayon qui n’est pas fini&#xa0;: déplacez-le ou retirez-le</translation>
    </message>
    <message>
        <source>is no table of cylinders: its first line should name the columns radius, length, start_x ..., axis_x ..., parent, as TreeQSM does</source>
        <translation>n’est pas un tableau de cylindres&#xa0;: sa première ligne devrait nommer les colonnes radius, length, start_x ..., axis_x ..., parent, comme le fait TreeQSM</translation>
    </message>
    <message>
        <source>columns that are not kept: %1</source>
        <translation>colonnes qui ne sont pas gardées&#xa0;: %1</translation>
    </message>
    <message>
        <source>1 point lies far from all others, %1 away: the step Clean leaves it out, and spacing, size and view are those of the others</source>
        <translation>1 point est loin de tous les autres, à %1&#xa0;: l’étape Nettoyer l’écarte, et l’espacement, la taille et la vue sont ceux des autres</translation>
    </message>
    <message>
        <source>%1 points lie far from all others, up to %2 away: the step Clean leaves them out, and spacing, size and view are those of the others</source>
        <translation>%1 points sont loin de tous les autres, jusqu’à %2&#xa0;: l’étape Nettoyer les écarte, et l’espacement, la taille et la vue sont ceux des autres</translation>
    </message>
    <message>
        <source>%1 of %2 points lie at the place of another: each place counts once</source>
        <translation>%1 points sur %2 sont à la place d’un autre&#xa0;: chaque place compte une fois</translation>
    </message>
    <message>
        <source>%1 of %2 points are not finite, or beyond any plant, and are left out</source>
        <translation>%1 points sur %2 ne sont pas finis, ou sont plus loin qu’aucune plante, et sont laissés de côté</translation>
    </message>
    <message>
        <source>holds no graph</source>
        <translation>ne contient pas de graphe</translation>
    </message>
    <message>
        <source>holds no nodes</source>
        <translation>ne contient pas de nœuds</translation>
    </message>
    <message>
        <source>its data %1 are left out</source>
        <translation>ses données %1 sont écartées</translation>
    </message>
    <message>
        <source>the node %1 has no %2: its position is expected as data x, y and z</source>
        <translation>le nœud %1 n’a pas de %2&#xa0;: sa position est attendue comme données x, y et z</translation>
    </message>
    <message>
        <source>the node has no id</source>
        <translation>le nœud n’a pas d’id</translation>
    </message>
    <message>
        <source>the id %1 occurs twice</source>
        <translation>l’id %1 apparaît deux fois</translation>
    </message>
    <message>
        <source>the source of the edge, %1, is no node of the graph</source>
        <translation>la source de l’arête, %1, n’est pas un nœud du graphe</translation>
    </message>
    <message>
        <source>the target of the edge, %1, is no node of the graph</source>
        <translation>la cible de l’arête, %1, n’est pas un nœud du graphe</translation>
    </message>
    <message>
        <source>1 directed edge among undirected ones is left out</source>
        <translation>1 arête orientée parmi des arêtes non orientées est écartée</translation>
    </message>
    <message>
        <source>%1 directed edges among undirected ones are left out</source>
        <translation>%1 arêtes orientées parmi des arêtes non orientées sont écartées</translation>
    </message>
    <message>
        <source>the node %1 has two parents: a skeleton is a tree</source>
        <translation>le nœud %1 a deux parents&#xa0;: un squelette est un arbre</translation>
    </message>
    <message>
        <source>expected 7 fields parted by tabs (%1), found %2</source>
        <translation>7 champs séparés par des tabulations (%1) sont attendus, trouvé %2</translation>
    </message>
    <message>
        <source>the radius is negative</source>
        <translation>le rayon est négatif</translation>
    </message>
    <message>
        <source>the parent %1 is not in the list</source>
        <translation>le parent %1 n’est pas dans la liste</translation>
    </message>
    <message>
        <source>the node is among its own ancestors: correct its parent</source>
        <translation>le nœud est parmi ses propres ancêtres&#xa0;: corrigez son parent</translation>
    </message>
    <message>
        <source>has no edge types: the child that carries most continues each axis</source>
        <translation>n’a pas de types d’arêtes&#xa0;: l’enfant qui porte le plus continue chaque axe</translation>
    </message>
    <message>
        <source>holds no topology</source>
        <translation>ne contient pas de topologie</translation>
    </message>
    <message>
        <source>nodes are placed at the upper ends of the shapes of their organs; the meshes are left out</source>
        <translation>les nœuds sont placés aux extrémités supérieures des formes de leurs organes&#xa0;; les maillages sont écartés</translation>
    </message>
    <message>
        <source>expected a scale from %1 to %2, found %3</source>
        <translation>une échelle de %1 à %2 est attendue, trouvé %3</translation>
    </message>
    <message>
        <source>the vertex has no class</source>
        <translation>le sommet n’a pas de classe</translation>
    </message>
    <message>
        <source>this vertex of scale %1 is attached to nothing of its scale</source>
        <translation>ce sommet d’échelle %1 n’est attaché à rien de son échelle</translation>
    </message>
    <message>
        <source>a part of a vertex of scale %1 must have a finer scale, not %2</source>
        <translation>une partie d’un sommet d’échelle %1 doit avoir une échelle plus fine, pas %2</translation>
    </message>
    <message>
        <source>has more features, on more vertices, than fit into memory</source>
        <translation>a plus d’attributs, sur plus de sommets, que la mémoire n’en peut contenir</translation>
    </message>
    <message>
        <source>expected a matrix of 12 numbers, found more</source>
        <translation>une matrice de 12 nombres est attendue, trouvé davantage</translation>
    </message>
    <message>
        <source>expected a matrix of 12 numbers, found %1</source>
        <translation>une matrice de 12 nombres est attendue, trouvé %1</translation>
    </message>
    <message>
        <source>holds no polylines of roots</source>
        <translation>ne contient pas de polylignes de racines</translation>
    </message>
    <message>
        <source>its unit is %1, at a resolution of %2</source>
        <translation>son unité est %1, à une résolution de %2</translation>
    </message>
    <message>
        <source>its points have no z, which is taken as 0</source>
        <translation>ses points n’ont pas de z, qui est pris pour 0</translation>
    </message>
    <message>
        <source>1 root has no polyline and is left out</source>
        <translation>1 racine n’a pas de polyligne et est écartée</translation>
    </message>
    <message>
        <source>%1 roots have no polyline and are left out</source>
        <translation>%1 racines n’ont pas de polyligne et sont écartées</translation>
    </message>
    <message>
        <source>1 root names a parent-node that is not there, and is attached to the nearest node</source>
        <translation>1 racine nomme un parent-node qui n’existe pas, et est attachée au nœud le plus proche</translation>
    </message>
    <message>
        <source>%1 roots name a parent-node that is not there, and are attached to the nearest node</source>
        <translation>%1 racines nomment un parent-node qui n’existe pas, et sont attachées au nœud le plus proche</translation>
    </message>
    <message>
        <source>its functions %1 are left out</source>
        <translation>ses fonctions %1 sont écartées</translation>
    </message>
    <message>
        <source>too many roots on long ones have no parent-node</source>
        <translation>trop de racines sur de longues racines n’ont pas de parent-node</translation>
    </message>
    <message>
        <source>no axis has a length: there is no surface to write</source>
        <translation>aucun axe n’a de longueur&#xa0;: il n’y a pas de surface à écrire</translation>
    </message>
    <message>
        <source>expected 7 numbers (id type x y z radius parent), found %1</source>
        <translation>7 nombres (id type x y z radius parent) sont attendus, trouvé %1</translation>
    </message>
    <message>
        <source>expected the names of the fields, x,y,z,radius,parent_id, found %1</source>
        <translation>les noms des champs, x,y,z,radius,parent_id, sont attendus, trouvé %1</translation>
    </message>
    <message>
        <source>expected %1 fields and then a multiple of %2, found %3</source>
        <translation>%1 champs puis un multiple de %2 sont attendus, trouvé %3</translation>
    </message>
    <message>
        <source>the tree has several segments, and no parent_id to join them</source>
        <translation>l’arbre a plusieurs segments, et pas de parent_id pour les joindre</translation>
    </message>
    <message>
        <source>segment %1: its parent_id is %2, but the tree has segments 0 to %3</source>
        <translation>segment %1&#xa0;: son parent_id est %2, mais l’arbre a les segments 0 à %3</translation>
    </message>
    <message>
        <source>segment %1: expected a number as %2, found %3</source>
        <translation>segment %1&#xa0;: un nombre est attendu pour %2, trouvé %3</translation>
    </message>
    <message>
        <source>holds no trees</source>
        <translation>ne contient pas d’arbres</translation>
    </message>
    <message>
        <source>its fields %1 are left out</source>
        <translation>ses champs %1 sont écartés</translation>
    </message>
    <message>
        <source>node %1 has a position or radius that is not finite: correct it before saving</source>
        <translation>le nœud&#xa0;%1 a une position ou un rayon qui n’est pas fini&#xa0;: corrigez-le avant d’enregistrer</translation>
    </message>
    <message>
        <source>%1 stands for a coordinate or radius of a vertex %2, expected a number</source>
        <translation>%1 est donné comme coordonnée ou rayon d’un sommet %2, un nombre est attendu</translation>
    </message>
    <message>
        <source>vertex %1, %2: its place or radius is beyond 1e12, as of no plant: correct or remove it</source>
        <translation>sommet %1, %2&#xa0;: sa position ou son rayon dépasse 1e12, ce qu’aucune plante n’atteint&#xa0;: corrigez-le ou retirez-le</translation>
    </message>
    <message>
        <source>1 more place was repaired</source>
        <translation>1 autre endroit a été réparé</translation>
    </message>
    <message>
        <source>%1 more places were repaired</source>
        <translation>%1 autres endroits ont été réparés</translation>
    </message>
    <message>
        <source>the column %1 stands there twice</source>
        <translation>la colonne %1 y figure deux fois</translation>
    </message>
    <message>
        <source>the feature %1 has a column but no type in FEATURES and is taken as ALPHA</source>
        <translation>l’attribut %1 a une colonne mais pas de type dans FEATURES et est lu comme ALPHA</translation>
    </message>
    <message>
        <source>the columns are parted by blanks: put tabs between them</source>
        <translation>les colonnes sont séparées par des espaces&#xa0;: mettez des tabulations entre elles</translation>
    </message>
    <message>
        <source>expected the line of columns, ENTITY-CODE ..., found %1</source>
        <translation>la ligne des colonnes, ENTITY-CODE ..., est attendue, trouvé %1</translation>
    </message>
    <message>
        <source>ends before the columns of its section MTG: it is cut short</source>
        <translation>s’arrête avant les colonnes de sa section MTG&#xa0;: le fichier est tronqué</translation>
    </message>
    <message>
        <source>values stand without a code before them</source>
        <translation>des valeurs figurent sans code devant elles</translation>
    </message>
    <message>
        <source>the code %1 stands among the columns of values: move it to the left, or these to the right</source>
        <translation>le code %1 est parmi les colonnes de valeurs&#xa0;: déplacez-le à gauche, ou celles-ci à droite</translation>
    </message>
    <message>
        <source>1 value stands in a column without a name and is left out</source>
        <translation>1 valeur est dans une colonne sans nom et est laissée de côté</translation>
    </message>
    <message>
        <source>%1 values stand in columns without a name and are left out</source>
        <translation>%1 valeurs sont dans des colonnes sans nom et sont laissées de côté</translation>
    </message>
    <message>
        <source>%1 stands left of the columns of values and is left out</source>
        <translation>%1 est à gauche des colonnes de valeurs et est laissé de côté</translation>
    </message>
    <message>
        <source>two codes stand in one line, %1 and %2</source>
        <translation>deux codes sont sur une même ligne, %1 et %2</translation>
    </message>
    <message>
        <source>%1 is %2, expected a number with a decimal point, not a comma</source>
        <translation>%1 vaut %2, un nombre avec un point décimal, et non une virgule, est attendu</translation>
    </message>
    <message>
        <source>%1 is %2, expected a number</source>
        <translation>%1 vaut %2, un nombre est attendu</translation>
    </message>
    <message>
        <source>the ranges up to here share too many values: correct the index</source>
        <translation>les plages jusqu’ici partagent trop de valeurs&#xa0;: corrigez l’indice</translation>
    </message>
    <message>
        <source>1 code with &lt; but no ^ stands below another of its column, in line %1: it follows the vertex above it, as OpenAlea reads</source>
        <translation>1 code avec &lt; mais sans ^ est sous un autre de sa colonne, à la ligne %1&#xa0;: il suit le sommet au-dessus de lui, comme lit OpenAlea</translation>
    </message>
    <message>
        <source>1 code with &lt; but no ^ stands below another of its column, in line %1: it follows the column before, as the specification says</source>
        <translation>1 code avec &lt; mais sans ^ est sous un autre de sa colonne, à la ligne %1&#xa0;: il suit la colonne précédente, comme le dit la spécification</translation>
    </message>
    <message>
        <source>%1 codes with &lt; but no ^ stand below others of their column, the first in line %2: they follow the vertex above them, as OpenAlea reads</source>
        <translation>%1 codes avec &lt; mais sans ^ sont sous d’autres de leur colonne, le premier à la ligne %2&#xa0;: ils suivent le sommet au-dessus d’eux, comme lit OpenAlea</translation>
    </message>
    <message>
        <source>%1 codes with &lt; but no ^ stand below others of their column, the first in line %2: they follow the column before, as the specification says</source>
        <translation>%1 codes avec &lt; mais sans ^ sont sous d’autres de leur colonne, le premier à la ligne %2&#xa0;: ils suivent la colonne précédente, comme le dit la spécification</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>est vide</translation>
    </message>
    <message>
        <source>the vertex %1 of scale %2 is attached to %3, but what it is a part of is not attached there: no MTG text can say that; join both to one unit, or let the unit begin there</source>
        <translation>le sommet %1 d’échelle %2 est attaché à %3, mais ce dont il fait partie n’y est pas attaché&#xa0;: aucun texte MTG ne peut le dire&#xa0;; joignez les deux en une unité, ou faites-y commencer l’unité</translation>
    </message>
    <message>
        <source>the units of the plant are attached to each other in a ring: no MTG text can say that</source>
        <translation>les unités de la plante sont attachées les unes aux autres en anneau&#xa0;: aucun texte MTG ne peut le dire</translation>
    </message>
    <message>
        <source>the code FORM-B is older than the syntax of MTG files, which does not say how to read it: code the plant in FORM-A</source>
        <translation>le code FORM-B est plus ancien que la syntaxe des fichiers MTG, qui ne dit pas comment le lire&#xa0;: codez la plante en FORM-A</translation>
    </message>
    <message>
        <source>only MTG files of code FORM-A can be read, this one is of code %1</source>
        <translation>seuls les fichiers MTG de code FORM-A peuvent être lus, celui-ci est de code %1</translation>
    </message>
    <message>
        <source>expected a symbol and its scale, found %1</source>
        <translation>un symbole et son échelle sont attendus, trouvé %1</translation>
    </message>
    <message>
        <source>expected the scale of %1, a number from 0 to %2, found %3</source>
        <translation>l’échelle de %1 est attendue, un nombre de 0 à %2, trouvé %3</translation>
    </message>
    <message>
        <source>the symbol %1 is too long</source>
        <translation>le symbole %1 est trop long</translation>
    </message>
    <message>
        <source>the feature %1 has no type and is taken as ALPHA</source>
        <translation>l’attribut %1 n’a pas de type et est lu comme ALPHA</translation>
    </message>
    <message>
        <source>the feature %1 is listed twice</source>
        <translation>l’attribut %1 figure deux fois dans la liste</translation>
    </message>
    <message>
        <source>the section %1 stands before &apos;CODE : FORM-A&apos;: put that line at the top</source>
        <translation>la section %1 est avant «&#xa0;CODE : FORM-A&#xa0;»&#xa0;: mettez cette ligne en tête</translation>
    </message>
    <message>
        <source>expected &apos;CODE: FORM-A&apos;, found %1: is this an MTG file?</source>
        <translation>«&#xa0;CODE: FORM-A&#xa0;» est attendu, trouvé %1&#xa0;: est-ce un fichier MTG&#xa0;?</translation>
    </message>
    <message>
        <source>the class %1 is listed twice: the first line of it counts</source>
        <translation>la classe %1 figure deux fois dans la liste&#xa0;: sa première ligne compte</translation>
    </message>
    <message>
        <source>the line &apos;MTG :&apos; is missing before that of the columns</source>
        <translation>la ligne «&#xa0;MTG :&#xa0;» manque avant celle des colonnes</translation>
    </message>
    <message>
        <source>no CLASSES are listed before the vertices</source>
        <translation>aucune classe (CLASSES) n’est indiquée avant les sommets</translation>
    </message>
    <message>
        <source>has no section &apos;MTG:&apos;: it is no MTG file, or is cut short</source>
        <translation>n’a pas de section «&#xa0;MTG:&#xa0;»&#xa0;: ce n’est pas un fichier MTG, ou il est tronqué</translation>
    </message>
    <message>
        <source>1 vertex has no position and is put evenly between neighbors</source>
        <translation>1 sommet n’a pas de position et est placé régulièrement entre ses voisins</translation>
    </message>
    <message>
        <source>%1 vertices have no position and are put evenly between neighbors</source>
        <translation>%1 sommets n’ont pas de position et sont placés régulièrement entre leurs voisins</translation>
    </message>
    <message>
        <source>1 vertex has no position and is passed over</source>
        <translation>1 sommet n’a pas de position et est ignoré</translation>
    </message>
    <message>
        <source>%1 vertices have no position and are passed over</source>
        <translation>%1 sommets n’ont pas de position et sont ignorés</translation>
    </message>
    <message>
        <source>1 radius is negative and is taken as not known</source>
        <translation>1 rayon est négatif et est considéré comme inconnu</translation>
    </message>
    <message>
        <source>%1 radii are negative and are taken as not known</source>
        <translation>%1 rayons sont négatifs et sont considérés comme inconnus</translation>
    </message>
    <message>
        <source>its vertices are of more than %1 scales: check the section CLASSES</source>
        <translation>ses sommets sont de plus de %1 échelles&#xa0;: vérifiez la section CLASSES</translation>
    </message>
    <message>
        <source>none of its vertices has a position, in features XX, YY and ZZ: it describes a plant without its shape, which can be shown, reported (info) and written as MTG or OPF</source>
        <translation>aucun de ses sommets n’a de position, dans les attributs XX, YY et ZZ&#xa0;: il décrit une plante sans sa forme, qui peut être montrée, décrite (info) et écrite en MTG ou OPF</translation>
    </message>
    <message>
        <source>is no UTF-8 and is read as Latin-1</source>
        <translation>n’est pas en UTF-8 et est lu comme Latin-1</translation>
    </message>
    <message>
        <source>1 line begins with # and holds a code: it is passed over whole</source>
        <translation>1 ligne commence par # et contient un code&#xa0;: elle est ignorée en entier</translation>
    </message>
    <message>
        <source>%1 lines begin with # and hold codes: they are passed over whole</source>
        <translation>%1 lignes commencent par # et contiennent des codes&#xa0;: elles sont ignorées en entier</translation>
    </message>
    <message>
        <source>a comment (# is not closed with #); it is taken to end at the next tab or line end</source>
        <translation>un commentaire (# n’est pas fermé par #)&#xa0;; il est considéré comme fini à la prochaine tabulation ou fin de ligne</translation>
    </message>
    <message>
        <source>expected /, &lt; or + and a label, as in &apos;^&lt;U2&apos;</source>
        <translation>/, &lt; ou + et une étiquette sont attendus, comme dans «&#xa0;^&lt;U2&#xa0;»</translation>
    </message>
    <message>
        <source>nothing stands above the *</source>
        <translation>il n’y a rien au-dessus du *</translation>
    </message>
    <message>
        <source>the alias %1 is given again: from here on it means this vertex</source>
        <translation>l’alias %1 est donné à nouveau&#xa0;: à partir d’ici il désigne ce sommet</translation>
    </message>
    <message>
        <source>this is attached to column %1, where nothing stands before it: move it to the left</source>
        <translation>ceci est attaché à la colonne %1, où rien ne le précède&#xa0;: déplacez-le à gauche</translation>
    </message>
    <message>
        <source>expected /, &lt; or + before %1</source>
        <translation>/, &lt; ou + est attendu avant %1</translation>
    </message>
    <message>
        <source>the name in %1 is not closed with )</source>
        <translation>le nom dans %1 n’est pas fermé par )</translation>
    </message>
    <message>
        <source>no vertex before is named %1 in the column Alias</source>
        <translation>aucun sommet précédent ne s’appelle %1 dans la colonne Alias</translation>
    </message>
    <message>
        <source>%1 may stand only at the beginning of a code</source>
        <translation>%1 ne peut figurer qu’au début d’un code</translation>
    </message>
    <message>
        <source>the range to %1 does not count up from a vertex of its class: taken as a single edge</source>
        <translation>la plage jusqu’à %1 ne part pas d’un sommet de sa classe d’indice plus petit&#xa0;: elle est lue comme une seule arête</translation>
    </message>
    <message>
        <source>the ranges up to %1 stand for more than %2 vertices: correct the index</source>
        <translation>les plages jusqu’à %1 représentent plus de %2 sommets&#xa0;: corrigez l’indice</translation>
    </message>
    <message>
        <source>%1 begins with no symbol of the section CLASSES (%2): type one of these, and behind it its index, as in U1 or S16.1</source>
        <translation>%1 ne commence par aucun symbole de la section CLASSES (%2)&#xa0;: saisissez l’un d’eux, suivi de son indice, comme dans U1 ou S16.1</translation>
    </message>
    <message>
        <source>the index in %1 has a dot without a number on both sides: type it as in U16 or U16.1</source>
        <translation>l’indice dans %1 a un point sans nombre de chaque côté&#xa0;: saisissez-le comme dans U16 ou U16.1</translation>
    </message>
    <message>
        <source>the index in %1 is too large</source>
        <translation>l’indice dans %1 est trop grand</translation>
    </message>
    <message>
        <source>%1 is of no class, and follows nothing</source>
        <translation>%1 n’est d’aucune classe, et ne suit rien</translation>
    </message>
    <message>
        <source>the class %1 is not declared and is taken to be of scale %2</source>
        <translation>la classe %1 n’est pas déclarée et est supposée d’échelle %2</translation>
    </message>
    <message>
        <source>there are too many scales</source>
        <translation>il y a trop d’échelles</translation>
    </message>
    <message>
        <source>%1 is of scale %2, and nothing stands before it that it could be attached to</source>
        <translation>%1 est d’échelle %2, et rien de ce qui le précède ne peut le porter</translation>
    </message>
    <message>
        <source>no vertex of its scale stands before %1: it is taken as the first part of its unit (/)</source>
        <translation>aucun sommet de son échelle ne précède %1&#xa0;: il est lu comme la première partie de son unité (/)</translation>
    </message>
    <message>
        <source>the value of %1 %2 cannot stand in an MTG text: take out tabs, line ends, comment signs (# or ;) and blanks around it</source>
        <translation>pour %1, la valeur %2 ne peut pas figurer dans un texte MTG&#xa0;: retirez les tabulations, les fins de ligne, les signes de commentaire (# ou&#xa0;;) et les espaces qui l’entourent</translation>
    </message>
    <message>
        <source>the feature %1 cannot stand in an MTG text: take out tabs, line ends, comment signs (# or ;) and blanks around it</source>
        <translation>l’attribut %1 ne peut pas figurer dans un texte MTG&#xa0;: retirez les tabulations, les fins de ligne, les signes de commentaire (# ou&#xa0;;) et les espaces qui l’entourent</translation>
    </message>
    <message>
        <source>the alias %1 cannot stand in an MTG text: take out tabs, line ends, comment signs (# or ;) and blanks around it</source>
        <translation>l’alias %1 ne peut pas figurer dans un texte MTG&#xa0;: retirez les tabulations, les fins de ligne, les signes de commentaire (# ou&#xa0;;) et les espaces qui l’entourent</translation>
    </message>
    <message>
        <source>the class %1 cannot stand in an MTG text: take out tabs, line ends, comment signs (# or ;) and blanks around it</source>
        <translation>la classe %1 ne peut pas figurer dans un texte MTG&#xa0;: retirez les tabulations, les fins de ligne, les signes de commentaire (# ou&#xa0;;) et les espaces qui l’entourent</translation>
    </message>
    <message>
        <source>the vertex %1 is of scale %2, but no class of this symbol and scale is listed: rename its class</source>
        <translation>le sommet %1 est d’échelle %2, mais aucune classe de ce symbole et de cette échelle n’est déclarée&#xa0;: renommez sa classe</translation>
    </message>
    <message>
        <source>more vertices would be read from MTG text than the plant has: give each class a symbol that is not the beginning of another one</source>
        <translation>plus de sommets seraient lus du texte MTG que la plante n’en a&#xa0;: donnez à chaque classe un symbole qui n’est pas le début d’un autre</translation>
    </message>
    <message>
        <source>the vertex %1 would be read from MTG text as another: give its class a symbol that is not the beginning of another one</source>
        <translation>le sommet %1 serait lu du texte MTG comme un autre&#xa0;: donnez à sa classe un symbole qui n’est pas le début d’un autre</translation>
    </message>
    <message>
        <source>has no positions: it is a plant without its shape</source>
        <translation>n’a pas de positions&#xa0;: c’est une plante sans sa forme</translation>
    </message>
    <message>
        <source>a plant needs at least 2 points: check the scan</source>
        <translation>une plante demande au moins 2 points&#xa0;: vérifiez le scan</translation>
    </message>
    <message>
        <source>all points of the scan are at the same place: check the scan</source>
        <translation>tous les points du scan sont au même endroit&#xa0;: vérifiez le scan</translation>
    </message>
    <message>
        <source>no stem is found from %1 to %2 above the ground: choose other heights by plant.slab_from and plant.slab_to, or say where plants stand</source>
        <translation>aucune tige n’est trouvée de %1 à %2 au-dessus du sol&#xa0;: choisissez d’autres hauteurs par plant.slab_from et plant.slab_to, ou indiquez où sont les plantes</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no axis that points up</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un axe qui pointe vers le haut</translation>
    </message>
    <message>
        <source>the root of the plant is no place</source>
        <translation>la racine de la plante n’est pas un endroit</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no option of a project</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une option d’un projet</translation>
    </message>
    <message>
        <source>fewer than 2 points are left after cleaning: clean less, choose method none, or bring points back</source>
        <translation>moins de 2 points restent après le nettoyage&#xa0;: nettoyez moins, choisissez la méthode none, ou reprenez des points</translation>
    </message>
    <message>
        <source>%1 is %2: choose a whole number from %3 to %4</source>
        <translation>%1 vaut %2&#xa0;: choisissez un nombre entier de %3 à %4</translation>
    </message>
    <message>
        <source>%1 is %2: choose a value from %3 to %4 (the points are %5 apart)</source>
        <translation>%1 vaut %2&#xa0;: choisissez une valeur de %3 à %4 (les points sont espacés de %5)</translation>
    </message>
    <message>
        <source>%1 is %2: choose a value from %3 to %4</source>
        <translation>%1 vaut %2&#xa0;: choisissez une valeur de %3 à %4</translation>
    </message>
    <message>
        <source>%1 takes no %2: choose one of %3</source>
        <translation>%1 n’accepte pas %2&#xa0;: choisissez parmi %3</translation>
    </message>
    <message>
        <source>%1 must be a number, or a length as &apos;6 spacings&apos;, &apos;0.01 heights&apos; or &apos;38 mm&apos;, not %2: write %1=%3, or %1=%3sp for spacings of the points</source>
        <translation>%1 doit être un nombre, ou une longueur comme &apos;6 spacings&apos;, &apos;0.01 heights&apos; ou &apos;38 mm&apos;, et non %2&#xa0;: écrivez %1=%3, ou %1=%3sp pour des espacements des points</translation>
    </message>
    <message>
        <source>%1 must be a number, not %2: write %1=%3</source>
        <translation>%1 doit être un nombre, et non %2&#xa0;: écrivez %1=%3</translation>
    </message>
    <message>
        <source>%1=%2: the unit of the scan is not known: say it first (--unit, or Unit in the window), or write %1=%3 for a scan in mm, %1=%4 for one in m</source>
        <translation>%1=%2&#xa0;: l’unité du scan n’est pas connue&#xa0;: indiquez-la d’abord (--unit, ou Unité dans la fenêtre), ou écrivez %1=%3 pour un scan en mm, %1=%4 pour un scan en m</translation>
    </message>
    <message>
        <source>%1 takes no &quot;%2&quot;: choose one of %3</source>
        <translation>%1 n’accepte pas «&#xa0;%2&#xa0;»&#xa0;: choisissez parmi %3</translation>
    </message>
    <message>
        <source>method %1 of step %2 has no option &quot;%3&quot;: it has none; choose a method by %2.method</source>
        <translation>la méthode %1 de l’étape %2 n’a pas d’option «&#xa0;%3&#xa0;»&#xa0;: elle n’en a aucune&#xa0;; choisissez une méthode par %2.method</translation>
    </message>
    <message>
        <source>method %1 of step %2 has no option &quot;%3&quot;: choose one of %4</source>
        <translation>la méthode %1 de l’étape %2 n’a pas d’option «&#xa0;%3&#xa0;»&#xa0;: choisissez parmi %4</translation>
    </message>
    <message>
        <source>the root lies %1 away from the scan: give a place in its coordinates</source>
        <translation>la racine est à %1 du scan&#xa0;: donnez un endroit dans ses coordonnées</translation>
    </message>
    <message>
        <source>the root lies %1 away from the points that are not set aside: give a place near them</source>
        <translation>la racine est à %1 des points qui ne sont pas mis de côté&#xa0;: donnez un endroit près d’eux</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must hold an object of options</source>
        <translation>«&#xa0;%1&#xa0;» doit contenir un objet d’options</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a number</source>
        <translation>«&#xa0;%1&#xa0;» doit être un nombre</translation>
    </message>
    <message>
        <source>a preset is a JSON object of steps, such as {&quot;contract&quot;: {&quot;radius&quot;: 12.5}}</source>
        <translation>un fichier de réglages est un objet JSON d’étapes, comme {&quot;contract&quot;: {&quot;radius&quot;: 12.5}}</translation>
    </message>
    <message>
        <source>is no text in UTF-8, but perhaps in UTF-16: save it as UTF-8</source>
        <translation>n’est pas un texte en UTF-8, mais peut-être en UTF-16&#xa0;: enregistrez-le en UTF-8</translation>
    </message>
    <message>
        <source>a preset is a JSON object of steps, such as {&quot;contract&quot;: {&quot;radius&quot;: 12.5}}; the JSON breaks off here</source>
        <translation>un fichier de réglages est un objet JSON d’étapes, comme {&quot;contract&quot;: {&quot;radius&quot;: 12.5}}&#xa0;; le JSON s’interrompt ici</translation>
    </message>
    <message>
        <source>a number is too large: write one below 1e12, as no length is larger</source>
        <translation>un nombre est trop grand&#xa0;: écrivez-en un inférieur à 1e12, car aucune longueur n’est plus grande</translation>
    </message>
    <message>
        <source>there is no step &quot;%1&quot;: choose one of %2</source>
        <translation>il n’y a pas d’étape «&#xa0;%1&#xa0;»&#xa0;: choisissez parmi %2</translation>
    </message>
    <message>
        <source>there is no method &quot;%1&quot; for step %2: choose one of %3</source>
        <translation>il n’y a pas de méthode «&#xa0;%1&#xa0;» pour l’étape %2&#xa0;: choisissez parmi %3</translation>
    </message>
    <message>
        <source>no points around node %1 are left by the rest of the plant: choose another node</source>
        <translation>le reste de la plante ne laisse aucun point autour du nœud %1&#xa0;: choisissez un autre nœud</translation>
    </message>
    <message>
        <source>nothing grows from node %1: choose another node, or prune less in the pipeline</source>
        <translation>rien ne pousse à partir du nœud %1&#xa0;: choisissez un autre nœud, ou élaguez moins dans la chaîne de traitement</translation>
    </message>
    <message>
        <source>what node %1 carries follows the points better than what would grow: it stays as it is</source>
        <translation>ce que porte le nœud %1 suit mieux les points que ce qui pousserait&#xa0;: cela reste tel quel</translation>
    </message>
    <message>
        <source>step %1, method %2: node %3 gets a position or radius that is not finite: choose another method, and check the scan for many points at one place</source>
        <translation>étape %1, méthode %2&#xa0;: le nœud %3 reçoit une position ou un rayon qui n’est pas fini&#xa0;: choisissez une autre méthode, et vérifiez si le scan a beaucoup de points au même endroit</translation>
    </message>
    <message>
        <source>all points that are left after cleaning are at the same place: clean less</source>
        <translation>tous les points qui restent après le nettoyage sont au même endroit&#xa0;: nettoyez moins</translation>
    </message>
    <message>
        <source>breaks off while it is read: try a copy of it</source>
        <translation>s’interrompt pendant la lecture&#xa0;: essayez une copie</translation>
    </message>
    <message>
        <source>the disk is full: free some room, or save elsewhere (%1)</source>
        <translation>le disque est plein&#xa0;: libérez de la place, ou enregistrez ailleurs (%1)</translation>
    </message>
    <message>
        <source>it may only be read: allow writing to it and its folder, or save elsewhere (%1)</source>
        <translation>il est en lecture seule&#xa0;: autorisez l’écriture du fichier et de son dossier, ou enregistrez ailleurs (%1)</translation>
    </message>
    <message>
        <source>it cannot be opened: check that its folder exists and may be written to (%1)</source>
        <translation>il ne peut pas être ouvert&#xa0;: vérifiez que son dossier existe et qu’on peut y écrire (%1)</translation>
    </message>
    <message>
        <source>another program is writing to it: close that, or save elsewhere (%1)</source>
        <translation>un autre programme est en train d’y écrire&#xa0;: fermez-le, ou enregistrez ailleurs (%1)</translation>
    </message>
    <message>
        <source>the disk does not do what it is asked: check it, or save elsewhere (%1)</source>
        <translation>le disque ne fait pas ce qui lui est demandé&#xa0;: vérifiez-le, ou enregistrez ailleurs (%1)</translation>
    </message>
    <message>
        <source>something in it is too big to be kept (%1)</source>
        <translation>quelque chose y est trop grand pour être gardé (%1)</translation>
    </message>
    <message>
        <source>there is not enough memory: close other programs (%1)</source>
        <translation>il n’y a pas assez de mémoire&#xa0;: fermez d’autres programmes (%1)</translation>
    </message>
    <message>
        <source>this should not happen: save elsewhere, and report it (%1)</source>
        <translation>cela ne devrait pas arriver&#xa0;: enregistrez ailleurs, et signalez-le (%1)</translation>
    </message>
    <message>
        <source>is no project of Espalier: choose another file</source>
        <translation>n’est pas un projet d’Espalier&#xa0;: choisissez un autre fichier</translation>
    </message>
    <message>
        <source>is damaged (%1): take a copy of it if you have one</source>
        <translation>est abîmé (%1)&#xa0;: prenez une copie si vous en avez une</translation>
    </message>
    <message>
        <source>node %1 has a position or radius that is not finite or too large, which a project cannot keep: undo what made it</source>
        <translation>le nœud&#xa0;%1 a une position ou un rayon qui n’est pas fini ou est trop grand, ce qu’un projet ne peut pas garder&#xa0;: annulez ce qui l’a produit</translation>
    </message>
    <message>
        <source>node %1 has a number too large for a project: start a new project with the plant</source>
        <translation>le nœud&#xa0;%1 a un numéro trop grand pour un projet&#xa0;: commencez un nouveau projet avec la plante</translation>
    </message>
    <message>
        <source>stored points end too early: open the scan again</source>
        <translation>les points enregistrés s’arrêtent trop tôt&#xa0;: ouvrez le scan à nouveau</translation>
    </message>
    <message>
        <source>stored points have too many stations: open the scan again</source>
        <translation>les points enregistrés ont trop de stations&#xa0;: ouvrez le scan à nouveau</translation>
    </message>
    <message>
        <source>stored points are followed by more: open the scan again</source>
        <translation>les points enregistrés sont suivis d’autre chose&#xa0;: ouvrez le scan à nouveau</translation>
    </message>
    <message>
        <source>stored points are not all finite: make them again</source>
        <translation>les points enregistrés ne sont pas tous finis&#xa0;: calculez-les à nouveau</translation>
    </message>
    <message>
        <source>may only be read: open it to read only, or open a copy</source>
        <translation>est protégé en écriture&#xa0;: ouvrez-le en lecture seule, ou ouvrez une copie</translation>
    </message>
    <message>
        <source>its &quot;%1&quot; are damaged: make them again</source>
        <translation>ses données «&#xa0;%1&#xa0;» sont abîmées&#xa0;: calculez-les à nouveau</translation>
    </message>
    <message>
        <source>is open to read only: save it elsewhere to edit it</source>
        <translation>est ouvert en lecture seule&#xa0;: enregistrez-le ailleurs pour le modifier</translation>
    </message>
    <message>
        <source>was removed while it was open: save it elsewhere</source>
        <translation>a été supprimé pendant qu’il était ouvert&#xa0;: enregistrez-le ailleurs</translation>
    </message>
    <message>
        <source>was replaced by another program: save it elsewhere</source>
        <translation>a été remplacé par un autre programme&#xa0;: enregistrez-le ailleurs</translation>
    </message>
    <message>
        <source>was made read-only while it was open: allow writing to it, or save elsewhere</source>
        <translation>a été protégé en écriture pendant qu’il était ouvert&#xa0;: autorisez son écriture, ou enregistrez ailleurs</translation>
    </message>
    <message>
        <source>numbers its nodes up to %1, too far for the %2 bytes that its plant and edits take: open a copy, or the plant as it was exported</source>
        <translation>numérote ses nœuds jusqu’à %1, trop loin pour les %2 octets que prennent sa plante et ses modifications&#xa0;: ouvrez une copie, ou la plante telle qu’elle a été exportée</translation>
    </message>
    <message>
        <source>numbers its nodes up to %1, too far for the %2 bytes that its plant and edits take: save the plant as an MTG, and begin a new project with that, which numbers its nodes anew</source>
        <translation>numérote ses nœuds jusqu’à %1, trop loin pour les %2 octets que prennent sa plante et ses modifications&#xa0;: enregistrez la plante en MTG, et commencez avec lui un nouveau projet, qui renumérote ses nœuds</translation>
    </message>
    <message>
        <source>is damaged: the plant is as it was after %1 of %2 edits, which is all that can be read: save it elsewhere</source>
        <translation>est abîmé&#xa0;: la plante est telle qu’elle était après %1 modifications sur %2, c’est tout ce qui peut être lu&#xa0;: enregistrez-le ailleurs</translation>
    </message>
    <message>
        <source>is damaged: nothing of its plant can be read; take a copy if you have one</source>
        <translation>est abîmé&#xa0;: rien de sa plante ne peut être lu&#xa0;; prenez une copie si vous en avez une</translation>
    </message>
    <message>
        <source>its version %1 is damaged: the others can be read</source>
        <translation>sa version %1 est abîmée&#xa0;: les autres peuvent être lues</translation>
    </message>
    <message>
        <source>some of its versions are damaged: the others can be read</source>
        <translation>certaines de ses versions sont abîmées&#xa0;: les autres peuvent être lues</translation>
    </message>
    <message>
        <source>is open in another window: go on there, open it to read only, or open a copy</source>
        <translation>est ouvert dans une autre fenêtre&#xa0;: continuez dans celle-ci, ouvrez-le en lecture seule, ou ouvrez une copie</translation>
    </message>
    <message>
        <source>is open in another window (%1): go on there, open it to read only, or open a copy</source>
        <translation>est ouvert dans une autre fenêtre (%1)&#xa0;: continuez dans celle-ci, ouvrez-le en lecture seule, ou ouvrez une copie</translation>
    </message>
    <message>
        <source>was written by a newer Espalier (schema %1, this program knows %2): open it with that one</source>
        <translation>a été écrit par un Espalier plus récent (schéma %1, ce programme connaît le %2)&#xa0;: ouvrez-le avec celui-là</translation>
    </message>
    <message>
        <source>its tables are not those of a project: choose another file</source>
        <translation>ses tables ne sont pas celles d’un projet&#xa0;: choisissez un autre fichier</translation>
    </message>
    <message>
        <source>only %1 % of the points are connected to the root: choose another root, or allow wider gaps</source>
        <translation>seuls %1 % des points sont reliés à la racine&#xa0;: choisissez une autre racine, ou permettez des lacunes plus larges</translation>
    </message>
    <message>
        <source>node %1: its place or radius is beyond 1e12, as of no plant: correct or remove it</source>
        <translation>nœud %1&#xa0;: sa position ou son rayon dépasse 1e12, ce qu’aucune plante n’atteint&#xa0;: corrigez-le ou retirez-le</translation>
    </message>
    <message>
        <source>a new node: its place or radius is beyond 1e12, as of no plant: correct or remove it</source>
        <translation>un nouveau nœud&#xa0;: sa position ou son rayon dépasse 1e12, ce qu’aucune plante n’atteint&#xa0;: corrigez-le ou retirez-le</translation>
    </message>
    <message>
        <source>the radius of the ball is 0: give one above it</source>
        <translation>le rayon de la boule est 0&#xa0;: donnez-en un plus grand</translation>
    </message>
    <message>
        <source>a ball of this radius goes between all points: there is no body; give it a larger radius</source>
        <translation>une boule de ce rayon passe entre tous les points&#xa0;: il n’y a pas de corps&#xa0;; donnez-lui un rayon plus grand</translation>
    </message>
    <message>
        <source>a position is no number: repair it, or leave it out of the envelope</source>
        <translation>une position n’est pas un nombre&#xa0;: corrigez-la, ou laissez-la hors de l’enveloppe</translation>
    </message>
    <message>
        <source>there is 1 point: an envelope needs 4 or more that fill space</source>
        <translation>il y a 1 point&#xa0;: une enveloppe en demande 4 ou plus qui remplissent l’espace</translation>
    </message>
    <message>
        <source>there are %1 points: an envelope needs 4 or more that fill space</source>
        <translation>il y a %1 points&#xa0;: une enveloppe en demande 4 ou plus qui remplissent l’espace</translation>
    </message>
    <message>
        <source>the points lie in a plane, on a line or at one place: an envelope needs points that fill space</source>
        <translation>les points sont dans un plan, sur une droite ou au même endroit&#xa0;: une enveloppe demande des points qui remplissent l’espace</translation>
    </message>
    <message>
        <source>no node has a radius: estimate radii first</source>
        <translation>aucun nœud n’a de rayon&#xa0;: estimez d’abord les rayons</translation>
    </message>
    <message>
        <source>cannot be read: %1: choose another folder</source>
        <translation>ne peut pas être lu&#xa0;: %1&#xa0;: choisissez un autre dossier</translation>
    </message>
    <message>
        <source>its name is no UTF-8: rename it</source>
        <translation>son nom n’est pas en UTF-8&#xa0;: renommez-le</translation>
    </message>
    <message>
        <source>no file is named: write a project or a scan</source>
        <translation>aucun fichier n’est nommé&#xa0;: écrivez un projet ou un scan</translation>
    </message>
    <message>
        <source>the %1 has over %2 bytes: write a shorter name</source>
        <translation>le champ %1 dépasse %2 octets&#xa0;: écrivez un nom plus court</translation>
    </message>
    <message>
        <source>there is no file %1: correct its name, or take the line out</source>
        <translation>il n’y a pas de fichier %1&#xa0;: corrigez son nom, ou retirez la ligne</translation>
    </message>
    <message>
        <source>%1 is neither a project nor a scan: name one of these</source>
        <translation>%1 n’est ni un projet ni un scan&#xa0;: nommez-en un</translation>
    </message>
    <message>
        <source>%1 came before: take the line out</source>
        <translation>%1 figure déjà plus haut&#xa0;: retirez la ligne</translation>
    </message>
    <message>
        <source>%1 is no UTF-8: rename the file</source>
        <translation>%1 n’est pas en UTF-8&#xa0;: renommez le fichier</translation>
    </message>
    <message>
        <source>no plant is listed: write a line for each below the first</source>
        <translation>aucune plante n’est listée&#xa0;: écrivez une ligne pour chacune sous la première</translation>
    </message>
    <message>
        <source>a line before means this plant, too: take one of the two out</source>
        <translation>une ligne plus haut désigne aussi cette plante&#xa0;: retirez l’une des deux</translation>
    </message>
    <message>
        <source>is longer than any such text: choose another file</source>
        <translation>est plus long que tout texte de cette sorte&#xa0;: choisissez un autre fichier</translation>
    </message>
    <message>
        <source>is a device: save it as a file and open that</source>
        <translation>est un périphérique&#xa0;: enregistrez-le dans un fichier et ouvrez celui-ci</translation>
    </message>
    <message>
        <source>is a pipe that nobody writes to: save it as a file and open that</source>
        <translation>est un tube dans lequel personne n’écrit&#xa0;: enregistrez-le dans un fichier et ouvrez celui-ci</translation>
    </message>
    <message>
        <source>holds 1 point, none of them finite: export it again</source>
        <translation>contient 1 point, qui n’est pas fini&#xa0;: exportez-le à nouveau</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>What does the step.</source>
        <translation>Ce qui accomplit l’étape.</translation>
    </message>
    <message>
        <source>1 image</source>
        <translation>1 image</translation>
    </message>
    <message>
        <source>%1 images</source>
        <translation>%1 images</translation>
    </message>
    <message>
        <source>%1, point format %2</source>
        <translation>%1, format de points %2</translation>
    </message>
    <message>
        <source>text</source>
        <translation>texte</translation>
    </message>
    <message>
        <source>binary</source>
        <translation>binaire</translation>
    </message>
    <message>
        <source>binary, big endian</source>
        <translation>binaire, gros-boutiste</translation>
    </message>
    <message>
        <source>binary, little endian</source>
        <translation>binaire, petit-boutiste</translation>
    </message>
    <message>
        <source>%1 of element %2</source>
        <translation>%1 de l’élément %2</translation>
    </message>
    <message>
        <source>grid of %1 x %2</source>
        <translation>grille de %1 × %2</translation>
    </message>
    <message>
        <source>grid of %1 x %2 and others</source>
        <translation>grille de %1 × %2, et d’autres</translation>
    </message>
    <message>
        <source>parted by commas</source>
        <translation>séparé par des virgules</translation>
    </message>
    <message>
        <source>parted by semicolons, decimal commas</source>
        <translation>séparé par des points-virgules, virgules décimales</translation>
    </message>
    <message>
        <source>parted by semicolons</source>
        <translation>séparé par des points-virgules</translation>
    </message>
    <message>
        <source>parted by blanks, decimal commas</source>
        <translation>séparé par des blancs, virgules décimales</translation>
    </message>
    <message>
        <source>parted by blanks</source>
        <translation>séparé par des blancs</translation>
    </message>
    <message>
        <source>the unit of the lengths is not known</source>
        <translation>l’unité des longueurs n’est pas connue</translation>
    </message>
    <message>
        <source>the reference begins above breast height</source>
        <translation>la référence commence au-dessus de la hauteur de poitrine</translation>
    </message>
    <message>
        <source>the plant begins above breast height</source>
        <translation>la plante commence au-dessus de la hauteur de poitrine</translation>
    </message>
    <message>
        <source>the reference has no radius at breast height</source>
        <translation>la référence n’a pas de rayon à hauteur de poitrine</translation>
    </message>
    <message>
        <source>the plant has no radius at breast height</source>
        <translation>la plante n’a pas de rayon à hauteur de poitrine</translation>
    </message>
    <message>
        <source>the stem of the reference does not rise that high</source>
        <translation>la tige de la référence ne monte pas si haut</translation>
    </message>
    <message>
        <source>the stem of the plant does not rise that high</source>
        <translation>la tige de la plante ne monte pas si haut</translation>
    </message>
    <message>
        <source>is a project: give the scan or the structure in it, which espalier convert writes, or open it in the window</source>
        <translation>est un projet&#xa0;: donnez le scan ou la structure qu’il contient, qu’espalier convert écrit, ou ouvrez-le dans la fenêtre</translation>
    </message>
    <message>
        <source>none of its %1 points lies in the box from %2 to %3: a sample of them lies from %4 to %5</source>
        <translation>aucun de ses %1 points n’est dans la boîte de %2 à %3&#xa0;: un échantillon s’étend de %4 à %5</translation>
    </message>
    <message>
        <source>nothing is left of the plants that are found: let fewer steps leave out points</source>
        <translation>il ne reste rien des plantes trouvées&#xa0;: laissez moins d’étapes écarter des points</translation>
    </message>
    <message>
        <source>no plant stands at the places that are given: give them in the coordinates of the scan, at the feet of stems</source>
        <translation>aucune plante ne se dresse aux endroits donnés&#xa0;: donnez-les dans les coordonnées du scan, au pied des tiges</translation>
    </message>
    <message>
        <source>From height</source>
        <translation>À partir de la hauteur</translation>
    </message>
    <message>
        <source>Points lower than this above the foot are left out, as those of a bare stem. 0: it is about the whole plant.</source>
        <translation>Les points plus bas que cela au-dessus du pied sont écartés, comme ceux d’une tige nue. 0&#xa0;: elle entoure toute la plante.</translation>
    </message>
    <message>
        <source>hardly a point lies higher than &quot;from&quot;, %1 above the foot: choose a lower height</source>
        <translation>presque aucun point n’est plus haut que «&#xa0;from&#xa0;», %1 au-dessus du pied&#xa0;: choisissez une hauteur moindre</translation>
    </message>
    <message>
        <source>Edges count as truncated cones. It has no bounds: how radii err is known of those that a reconstruction found or a hand typed, which here are under nine tenths of the volume</source>
        <translation>Les arêtes comptent comme des troncs de cône. Il est sans bornes&#xa0;: l’erreur des rayons n’est connue que de ceux qu’une reconstruction a trouvés ou qu’on a saisis, ici moins de neuf dixièmes du volume</translation>
    </message>
    <message>
        <source>&quot;%1&quot; stands here and once more: keep one of them</source>
        <translation>«&#xa0;%1&#xa0;» est ici et encore une fois&#xa0;: n’en gardez qu’un</translation>
    </message>
    <message>
        <source>the ground was set aside before</source>
        <translation>le sol a déjà été écarté</translation>
    </message>
    <message>
        <source>the plant has no radii: its volume, areas, diameters and light are left out or 0; estimate radii first</source>
        <translation>la plante n’a pas de rayons&#xa0;: son volume, ses surfaces, ses diamètres et sa lumière manquent ou valent 0&#xa0;; estimez d’abord les rayons</translation>
    </message>
    <message>
        <source>%1 % of the length has no radii: volume, areas, diameters and light lack that wood; estimate radii first</source>
        <translation>%1&#xa0;% de la longueur est sans rayons&#xa0;: ce bois manque au volume, aux surfaces, aux diamètres et à la lumière&#xa0;; estimez d’abord les rayons</translation>
    </message>
    <message>
        <source>there is no folder %1: make it, or choose another</source>
        <translation>il n’y a pas de dossier %1&#xa0;: créez-le, ou choisissez-en un autre</translation>
    </message>
    <message>
        <source>cannot be written: %1; open it to read only, or save it elsewhere</source>
        <translation>ne peut pas être écrit&#xa0;: %1&#xa0;; ouvrez-le en lecture seule, ou enregistrez-le ailleurs</translation>
    </message>
    <message>
        <source>holds no project and no scan itself: choose the folder that they lie in, or name them in a table</source>
        <translation>ne contient lui-même ni projet ni scan&#xa0;: choisissez le dossier où ils se trouvent, ou nommez-les dans un tableau</translation>
    </message>
    <message>
        <source>there is no column %1: name the columns in the first line, as %2</source>
        <translation>il n’y a pas de colonne %1&#xa0;: nommez les colonnes dans la première ligne, comme %2</translation>
    </message>
    <message>
        <source>Where points are so dense that needles, or the insides of stems and leaves, would become branches, keeps fewer of them.</source>
        <translation>Là où les points sont si denses que des aiguilles, ou l’intérieur des tiges et des feuilles, deviendraient des branches, en garde moins.</translation>
    </message>
</context>
<context>
    <name>espalier::ShownFlow</name>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Masquer</translation>
    </message>
    <message>
        <source>Hides the selected nodes, or the axis under the pointer, and the points of their wood</source>
        <translation>Masque les nœuds sélectionnés, ou l’axe sous le pointeur, et les points de leur bois</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>Isoler</translation>
    </message>
    <message>
        <source>Hides all but the selected nodes, or the axis under the pointer, and the points of their wood</source>
        <translation>Masque tout sauf les nœuds sélectionnés, ou l’axe sous le pointeur, et les points de leur bois</translation>
    </message>
    <message>
        <source>Show All Again</source>
        <translation>Tout réafficher</translation>
    </message>
    <message>
        <source>Shows what is hidden or clipped</source>
        <translation>Affiche ce qui est masqué ou découpé</translation>
    </message>
    <message>
        <source>Select Points Shown</source>
        <translation>Sélectionner les points affichés</translation>
    </message>
    <message>
        <source>Selects all points that are not hidden, in the slab and the box of Clipping</source>
        <translation>Sélectionne tous les points qui ne sont pas masqués, dans la tranche et la boîte du Découpage</translation>
    </message>
    <message>
        <source>Clipping</source>
        <translation>Découpage</translation>
    </message>
    <message>
        <source>Clipping…</source>
        <translation>Découpage…</translation>
    </message>
    <message>
        <source>Shows a slab or a box of the plant, and fades its back</source>
        <translation>Affiche une tranche ou une boîte de la plante, et estompe son arrière</translation>
    </message>
    <message>
        <source>put the pointer on a branch, or select nodes</source>
        <translation>placez le pointeur sur une branche, ou sélectionnez des nœuds</translation>
    </message>
    <message>
        <source>what was hidden here is shown again</source>
        <translation>ce qui était masqué ici est de nouveau affiché</translation>
    </message>
    <message>
        <source>the slab was moved to what you fly to</source>
        <translation>la tranche a été déplacée vers ce que la vue rejoint</translation>
    </message>
    <message>
        <source>the box was moved to what you fly to</source>
        <translation>la boîte a été déplacée vers ce que la vue rejoint</translation>
    </message>
    <message>
        <source>; </source>
        <translation>&#xa0;; </translation>
    </message>
    <message>
        <source>   {show_all} shows all of the plant</source>
        <translation>   {show_all} affiche toute la plante</translation>
    </message>
    <message>
        <source>No point is shown</source>
        <translation>Aucun point n’est affiché</translation>
    </message>
    <message>
        <source>%1 points selected</source>
        <translation>%1 points sélectionnés</translation>
    </message>
    <message>
        <source>%1 hidden</source>
        <translation>%1 masqué(s)</translation>
    </message>
</context>
<context>
    <name>espalier::SightFlow</name>
    <message>
        <source>1 point</source>
        <translation>1 point</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 points</translation>
    </message>
    <message>
        <source>%1 within %2</source>
        <translation>%1 à moins de %2</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>What the Method Sees</source>
        <translation>Ce que voit la méthode</translation>
    </message>
    <message>
        <source>Draws, at the point under the mouse, its neighbors, what its new place is from, directions and circles</source>
        <translation>Trace, au point sous la souris, ses voisins, ce dont vient sa nouvelle place, les directions et les cercles</translation>
    </message>
    <message>
        <source>Nothing is contracted yet: turn on Live Preview, or reconstruct</source>
        <translation>Rien n’est encore contracté&#xa0;: activez Aperçu en direct, ou reconstruisez</translation>
    </message>
    <message>
        <source>Point at the plant</source>
        <translation>Pointer sur la plante</translation>
    </message>
    <message>
        <source>Linearity %1 (1: along a line)</source>
        <translation>Linéarité %1 (1&#xa0;: le long d’une ligne)</translation>
    </message>
    <message>
        <source>Density %1 (0 thinnest, 1 densest)</source>
        <translation>Densité %1 (0 la plus faible, 1 la plus forte)</translation>
    </message>
    <message>
        <source>Circle of radius %1</source>
        <translation>Cercle de rayon %1</translation>
    </message>
</context>
<context>
    <name>espalier::SignDialog</name>
    <message>
        <source>Sign Structure</source>
        <translation>Signer la structure</translation>
    </message>
    <message>
        <source>I have looked at all of this structure, and to my knowledge it is right.</source>
        <translation>J’ai regardé toute cette structure, et à ma connaissance elle est juste.</translation>
    </message>
    <message>
        <source>To my knowledge this structure is right, also where I did not look closely.</source>
        <translation>À ma connaissance, cette structure est juste, même là où je n’ai pas regardé de près.</translation>
    </message>
    <message>
        <source>Why findings are left</source>
        <translation>Pourquoi des constats restent</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>A later edit breaks the seal, and undoing it mends it.</source>
        <translation>Une modification ultérieure rompt le sceau, et l’annuler le répare.</translation>
    </message>
    <message>
        <source>Sign</source>
        <translation>Signer</translation>
    </message>
    <message>
        <source>To sign, type why findings are left open</source>
        <translation>Pour signer, dites pourquoi des constats restent ouverts</translation>
    </message>
    <message>
        <source>To sign, type your name</source>
        <translation>Pour signer, tapez votre nom</translation>
    </message>
</context>
<context>
    <name>espalier::SnapFlow</name>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Snap to Nothing</source>
        <translation>Ne caler sur rien</translation>
    </message>
    <message>
        <source>A node that is dragged follows the pointer; with Ctrl it snaps to its section</source>
        <translation>Un nœud que l’on glisse suit le pointeur&#xa0;; avec Ctrl, il se cale sur sa section</translation>
    </message>
    <message>
        <source>Snap to Contracted Points</source>
        <translation>Caler sur les points contractés</translation>
    </message>
    <message>
        <source>A node that is dragged lies on the contracted points, unless Ctrl is held</source>
        <translation>Un nœud que l’on glisse se pose sur les points contractés, sauf si Ctrl est enfoncé</translation>
    </message>
    <message>
        <source>Snap to Section Center</source>
        <translation>Caler au centre de la section</translation>
    </message>
    <message>
        <source>A node that is dragged lies in the middle of the wood around it, unless Ctrl is held</source>
        <translation>Un nœud que l’on glisse se pose au milieu du bois qui l’entoure, sauf si Ctrl est enfoncé</translation>
    </message>
    <message>
        <source>there are no points to snap to: open the scan first</source>
        <translation>il n’y a pas de points sur lesquels caler&#xa0;: ouvrez d’abord le scan</translation>
    </message>
    <message>
        <source>there are no contracted points to snap to: reconstruct first</source>
        <translation>il n’y a pas de points contractés sur lesquels caler&#xa0;: reconstruisez d’abord</translation>
    </message>
</context>
<context>
    <name>espalier::StandFlow</name>
    <message>
        <source>Root and Up</source>
        <translation>Racine et haut</translation>
    </message>
    <message>
        <source>Root at the Lowest Point</source>
        <translation>Racine au point le plus bas</translation>
    </message>
    <message>
        <source>Forgets the root that was picked: it is where the scan is lowest</source>
        <translation>Oublie la racine qui a été choisie&#xa0;: elle est là où le scan est le plus bas</translation>
    </message>
    <message>
        <source>Up Is %1</source>
        <translation>Haut selon %1</translation>
    </message>
    <message>
        <source>The %1 axis of the file points up: the plant stands along it</source>
        <translation>L’axe %1 du fichier pointe vers le haut&#xa0;: la plante se dresse le long de cet axe</translation>
    </message>
    <message>
        <source>Root picked: reconstruct to grow the plant from there</source>
        <translation>Racine choisie&#xa0;: reconstruisez pour faire pousser la plante à partir de là</translation>
    </message>
    <message>
        <source>The root is where the scan is lowest</source>
        <translation>La racine est là où le scan est le plus bas</translation>
    </message>
</context>
<context>
    <name>espalier::StartPage</name>
    <message>
        <source>Open…</source>
        <translation>Ouvrir…</translation>
    </message>
    <message>
        <source>Try a sample plant</source>
        <translation>Essayer une plante d’exemple</translation>
    </message>
    <message>
        <source>Open a scan, or drop one here</source>
        <translation>Ouvrez un scan, ou déposez-en un ici</translation>
    </message>
    <message>
        <source>PLY, LAS, LAZ, E57, PCD, XYZ and their kin; a skeleton as MTG opens over its scan</source>
        <translation>PLY, LAS, LAZ, E57, PCD, XYZ et formats proches&#xa0;; un squelette en MTG s’ouvre sur son scan</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Récents</translation>
    </message>
    <message>
        <source>Not saved yet</source>
        <translation>Pas encore enregistré</translation>
    </message>
</context>
<context>
    <name>espalier::StatesFlow</name>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>Keep as A</source>
        <translation>Garder comme A</translation>
    </message>
    <message>
        <source>Keeps what is shown, to compare it with what comes next</source>
        <translation>Garde ce qui est montré, pour le comparer à ce qui vient ensuite</translation>
    </message>
    <message>
        <source>Forget A</source>
        <translation>Oublier A</translation>
    </message>
    <message>
        <source>Compares with the plant as it is again</source>
        <translation>Compare de nouveau avec la plante telle qu’elle est</translation>
    </message>
    <message>
        <source>Preview Alone</source>
        <translation>Aperçu seul</translation>
    </message>
    <message>
        <source>Shows the preview in place of the plant</source>
        <translation>Montre l’aperçu à la place de la plante</translation>
    </message>
    <message>
        <source>Divided View</source>
        <translation>Vue partagée</translation>
    </message>
    <message>
        <source>Shows A, or the plant, left of a divider and the preview right of it</source>
        <translation>Montre A, ou la plante, à gauche d’un séparateur et l’aperçu à sa droite</translation>
    </message>
    <message>
        <source>Side by Side</source>
        <translation>Côte à côte</translation>
    </message>
    <message>
        <source>Shows A, or the plant, in one view and the preview in another that moves with it</source>
        <translation>Montre A, ou la plante, dans une vue et l’aperçu dans une autre qui bouge avec elle</translation>
    </message>
    <message>
        <source>Color What Differs</source>
        <translation>Colorer ce qui diffère</translation>
    </message>
    <message>
        <source>Blend Points</source>
        <translation>Interpoler les points</translation>
    </message>
    <message>
        <source>Moves points between where they were scanned and where contraction puts them</source>
        <translation>Déplace les points entre là où ils ont été scannés et là où la contraction les place</translation>
    </message>
    <message>
        <source>there is no scan: open one first</source>
        <translation>il n’y a pas de scan&#xa0;: ouvrez-en un d’abord</translation>
    </message>
    <message>
        <source>the preview is not of the whole scan yet: wait a moment</source>
        <translation>l’aperçu n’est pas encore celui du scan entier&#xa0;: attendez un instant</translation>
    </message>
    <message>
        <source>A · %1</source>
        <translation>A · %1</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Par défaut</translation>
    </message>
    <message>
        <source>this is a preview: %1 makes it the skeleton, Esc drops it</source>
        <translation>ceci est un aperçu&#xa0;: %1 en fait le squelette, Échap l’abandonne</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>the plant</source>
        <translation>la plante</translation>
    </message>
    <message>
        <source>Colors the preview by where it differs from A, or from the plant, and adds what it lacks</source>
        <translation>Colore l’aperçu là où il diffère de A, ou de la plante, et ajoute ce qui lui manque</translation>
    </message>
    <message>
        <source>Kept as A: change a step   {compare_divided} compare in a divided view</source>
        <translation>Gardé comme A&#xa0;: changez une étape   {compare_divided} comparer dans une vue partagée</translation>
    </message>
</context>
<context>
    <name>espalier::StatusLine</name>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>espalier::StepForm</name>
    <message>
        <source>Runs the steps up to this one, those that are not up to date</source>
        <translation>Exécute les étapes jusqu’à celle-ci, celles qui ne sont pas à jour</translation>
    </message>
    <message>
        <source>Run up to %1</source>
        <translation>Exécuter jusqu’à %1</translation>
    </message>
    <message>
        <source>Method of %1</source>
        <translation>Méthode de %1</translation>
    </message>
    <message>
        <source>to be run again</source>
        <translation>à exécuter de nouveau</translation>
    </message>
    <message>
        <source>running</source>
        <translation>en cours</translation>
    </message>
    <message>
        <source>up to date</source>
        <translation>à jour</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>en échec</translation>
    </message>
    <message>
        <source>%1 set otherwise than by default</source>
        <translation>%1 réglés autrement que par défaut</translation>
    </message>
</context>
<context>
    <name>espalier::StrokeTool</name>
    <message>
        <source>Taken back. Release the button</source>
        <translation>Retiré. Relâchez le bouton</translation>
    </message>
    <message>
        <source>Finding the middle of the wood   Esc: drop</source>
        <translation>Recherche du milieu du bois   Échap&#xa0;: abandonner</translation>
    </message>
    <message>
        <source>Shift: only cut   Alt: only exchange   Both: only branch</source>
        <translation>Maj&#xa0;: seulement couper   Alt&#xa0;: seulement échanger   Les deux&#xa0;: seulement faire une branche</translation>
    </message>
    <message>
        <source>Draw across edges: cut   Along points: branch   Around a crossing: exchange arms</source>
        <translation>Tracer en travers d’arêtes&#xa0;: couper   Le long de points&#xa0;: faire une branche   Autour d’un croisement&#xa0;: échanger les bras</translation>
    </message>
    <message>
        <source>Release: cut off %1   Esc: leave it   %2</source>
        <translation>Relâcher&#xa0;: couper %1   Échap&#xa0;: laisser   %2</translation>
    </message>
    <message>
        <source>Draw around a crossing of two branches   Esc: leave it   %1</source>
        <translation>Tracer autour d’un croisement de deux branches   Échap&#xa0;: laisser   %1</translation>
    </message>
    <message>
        <source>Release: exchange the arms %1 and %2   Esc: leave it   %3</source>
        <translation>Relâcher&#xa0;: échanger les bras %1 et %2   Échap&#xa0;: laisser   %3</translation>
    </message>
    <message>
        <source>Release: make a branch of %1   Esc: leave it   %2</source>
        <translation>Relâcher&#xa0;: faire une branche de %1   Échap&#xa0;: laisser   %2</translation>
    </message>
    <message>
        <source>Release: make a branch along the points   Esc: leave it   %1</source>
        <translation>Relâcher&#xa0;: faire une branche le long des points   Échap&#xa0;: laisser   %1</translation>
    </message>
    <message>
        <source>Go on: across edges, along points, or around a crossing   Esc: leave it</source>
        <translation>Continuer&#xa0;: en travers d’arêtes, le long de points, ou autour d’un croisement   Échap&#xa0;: laisser</translation>
    </message>
    <message>
        <source>Cut off %1</source>
        <translation>Couper&#xa0;: %1</translation>
    </message>
    <message>
        <source>arms are exchanged where two branches cross: draw around one crossing</source>
        <translation>les bras sont échangés là où deux branches se croisent&#xa0;: tracez autour d’un croisement</translation>
    </message>
    <message>
        <source>Exchange the arms %1 and %2</source>
        <translation>Échanger les bras %1 et %2</translation>
    </message>
    <message>
        <source>there are no points to draw along: open the scan first</source>
        <translation>il n’y a pas de points le long desquels tracer&#xa0;: ouvrez d’abord le scan</translation>
    </message>
    <message>
        <source>Draw a branch of %1</source>
        <translation>Tracer à main levée une branche de %1</translation>
    </message>
    <message>
        <source>Draw a branch</source>
        <translation>Tracer à main levée une branche</translation>
    </message>
</context>
<context>
    <name>espalier::SuspectsFlow</name>
    <message>
        <source>What May Be Wrong</source>
        <translation>Ce qui peut être faux</translation>
    </message>
    <message>
        <source>Next Finding or Doubt</source>
        <translation>Constat ou doute suivant</translation>
    </message>
    <message>
        <source>Goes on to the next place that may be wrong, what matters most first</source>
        <translation>Va à l’endroit suivant qui peut être faux, le plus important d’abord</translation>
    </message>
    <message>
        <source>Previous Finding or Doubt</source>
        <translation>Constat ou doute précédent</translation>
    </message>
    <message>
        <source>Goes back to the place before that may be wrong</source>
        <translation>Revient à l’endroit précédent qui peut être faux</translation>
    </message>
    <message>
        <source>Ignore Finding</source>
        <translation>Ignorer le constat</translation>
    </message>
    <message>
        <source>Leaves what is chosen out of the list, or shows it again</source>
        <translation>Retire de la liste ce qui est choisi, ou l’affiche à nouveau</translation>
    </message>
    <message>
        <source>All Findings</source>
        <translation>Tous les constats</translation>
    </message>
    <message>
        <source>Selects the nodes of all findings of the checks</source>
        <translation>Sélectionne les nœuds de tous les constats des contrôles</translation>
    </message>
    <message>
        <source>Limits of the Checks</source>
        <translation>Limites des contrôles</translation>
    </message>
    <message>
        <source>Shows or hides from where on the checks report something</source>
        <translation>Affiche ou masque à partir d’où les contrôles signalent quelque chose</translation>
    </message>
    <message>
        <source>List All That May Be Wrong</source>
        <translation>Lister tout ce qui peut être faux</translation>
    </message>
    <message>
        <source>Whole plant</source>
        <translation>Toute la plante</translation>
    </message>
    <message>
        <source>Lists findings and doubts of the whole plant</source>
        <translation>Liste les constats et les doutes de toute la plante</translation>
    </message>
    <message>
        <source>List What Is in the View</source>
        <translation>Lister ce qui est dans la vue</translation>
    </message>
    <message>
        <source>In the view</source>
        <translation>Dans la vue</translation>
    </message>
    <message>
        <source>Lists only findings and doubts of what is in the view now</source>
        <translation>Ne liste que les constats et les doutes de ce qui est dans la vue maintenant</translation>
    </message>
    <message>
        <source>List What Is Selected</source>
        <translation>Lister ce qui est sélectionné</translation>
    </message>
    <message>
        <source>Selected</source>
        <translation>Sélection</translation>
    </message>
    <message>
        <source>Lists only findings and doubts of the nodes that are selected now</source>
        <translation>Ne liste que les constats et les doutes des nœuds sélectionnés maintenant</translation>
    </message>
    <message>
        <source>List the Selected Axes</source>
        <translation>Lister les axes sélectionnés</translation>
    </message>
    <message>
        <source>Selected axes</source>
        <translation>Axes sélectionnés</translation>
    </message>
    <message>
        <source>Lists only findings and doubts of the axes that selected nodes are on</source>
        <translation>Ne liste que les constats et les doutes des axes où se trouvent les nœuds sélectionnés</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Constats</translation>
    </message>
    <message>
        <source>Findings and Doubts Panel</source>
        <translation>Panneau des constats et des doutes</translation>
    </message>
    <message>
        <source>Shows or hides what the checks found, and what is in doubt</source>
        <translation>Affiche ou masque ce que les contrôles ont trouvé, et ce qui est en doute</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>All kinds</source>
        <translation>Toutes sortes</translation>
    </message>
    <message>
        <source>Ignored</source>
        <translation>Ignorés</translation>
    </message>
    <message>
        <source>The checks ended: %1</source>
        <translation>Les contrôles sont terminés&#xa0;: %1</translation>
    </message>
    <message>
        <source>Choose a finding or a doubt to ignore it</source>
        <translation>Choisissez un constat ou un doute pour l’ignorer</translation>
    </message>
    <message>
        <source>Show Doubt Again</source>
        <translation>Afficher à nouveau le doute</translation>
    </message>
    <message>
        <source>Ignore Doubt</source>
        <translation>Ignorer le doute</translation>
    </message>
    <message>
        <source>Show Finding Again</source>
        <translation>Réafficher le constat</translation>
    </message>
    <message>
        <source>select nodes first: what is selected now is listed</source>
        <translation>sélectionnez d’abord des nœuds&#xa0;: ce qui est sélectionné maintenant est listé</translation>
    </message>
    <message>
        <source>%1 · alone</source>
        <translation>%1 · seul</translation>
    </message>
    <message>
        <source>%1 · %2 nodes</source>
        <translation>%1 · %2 nœuds</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 · %2°</source>
        <translation>%1 · %2°</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 et %2</translation>
    </message>
    <message>
        <source>%1
%2 of the skeleton, wrong with a probability of %3 %</source>
        <translation>%1
%2 du squelette, faux avec une probabilité de %3 %</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <translation>%1&#xa0;: %2 %3</translation>
    </message>
    <message>
        <source>%1: Enter asks</source>
        <translation>%1&#xa0;: Entrée pose la question</translation>
    </message>
    <message>
        <source>There is no skeleton to check yet</source>
        <translation>Il n’y a pas encore de squelette à contrôler</translation>
    </message>
    <message>
        <source>1 place may be wrong</source>
        <translation>1 endroit peut être faux</translation>
    </message>
    <message>
        <source>%1 places may be wrong</source>
        <translation>%1 endroits peuvent être faux</translation>
    </message>
    <message>
        <source>Nothing to look at: all checks pass</source>
        <translation>Rien à regarder&#xa0;: tous les contrôles passent</translation>
    </message>
    <message>
        <source>Nothing to look at so far</source>
        <translation>Rien à regarder jusqu’ici</translation>
    </message>
    <message>
        <source>Open a scan to check against it, and to find what is in doubt</source>
        <translation>Ouvrez un scan pour contrôler avec lui, et pour trouver ce qui est en doute</translation>
    </message>
    <message>
        <source>Checking against the scan…</source>
        <translation>Contrôle par rapport au scan…</translation>
    </message>
    <message>
        <source>All points of the scan lie at one place: nothing can be asked about</source>
        <translation>Tous les points du scan sont au même endroit&#xa0;: il n’y a rien sur quoi interroger</translation>
    </message>
    <message>
        <source>Looking for doubts…</source>
        <translation>Recherche de doutes…</translation>
    </message>
    <message>
        <source>None of them is of this kind and part</source>
        <translation>Aucun n’est de cette sorte et de cette partie</translation>
    </message>
    <message>
        <source>About %1 % of the length is right</source>
        <translation>Environ %1 % de la longueur est juste</translation>
    </message>
    <message>
        <source>; 1 answer would make it %1 %</source>
        <translation>&#xa0;; 1 réponse la porterait à %1 %</translation>
    </message>
    <message>
        <source>; %1 answers would make it %2 %</source>
        <translation>&#xa0;; %1 réponses la porteraient à %2 %</translation>
    </message>
    <message>
        <source>What Is Listed</source>
        <translation>Ce qui est listé</translation>
    </message>
    <message>
        <source>Show Again</source>
        <translation>Réafficher</translation>
    </message>
    <message>
        <source>1 place is ignored</source>
        <translation>1 endroit est ignoré</translation>
    </message>
    <message>
        <source>%1 places are ignored</source>
        <translation>%1 endroits sont ignorés</translation>
    </message>
    <message>
        <source>Nothing else to look at: 1 place is ignored</source>
        <translation>Rien d’autre à regarder&#xa0;: 1 endroit est ignoré</translation>
    </message>
    <message>
        <source>Nothing else to look at: %1 places are ignored</source>
        <translation>Rien d’autre à regarder&#xa0;: %1 endroits sont ignorés</translation>
    </message>
    <message>
        <source>Ignore a doubt</source>
        <translation>Ignorer un doute</translation>
    </message>
    <message>
        <source>Ignore a finding</source>
        <translation>Ignorer un constat</translation>
    </message>
    <message>
        <source>Show a doubt again</source>
        <translation>Réafficher un doute</translation>
    </message>
    <message>
        <source>Show a finding again</source>
        <translation>Réafficher un constat</translation>
    </message>
</context>
<context>
    <name>espalier::SuspectsModel</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>How much of the plant, of its length and its ends, a look there probably puts right; below, the key of what helps</source>
        <translation>Combien de la plante, de sa longueur et de ses extrémités, un regard là corrige probablement&#xa0;; dessous, la touche qui aide</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Gain</translation>
    </message>
    <message>
        <source>What may be wrong, at which node, and how long, thick, sharp or large it is</source>
        <translation>Ce qui peut être faux, à quel nœud, et sa longueur, son épaisseur, son angle ou sa taille</translation>
    </message>
    <message>
        <source>What, at node</source>
        <translation>Quoi, au nœud</translation>
    </message>
</context>
<context>
    <name>espalier::SuspectsPanel</name>
    <message>
        <source>◂ Take Back</source>
        <translation>◂ Reprendre</translation>
    </message>
    <message>
        <source>Skip ▸</source>
        <translation>Passer ▸</translation>
    </message>
    <message>
        <source>Kind that is listed</source>
        <translation>Sorte qui est listée</translation>
    </message>
    <message>
        <source>Part of the plant that is listed</source>
        <translation>Partie de la plante qui est listée</translation>
    </message>
    <message>
        <source>What may be wrong</source>
        <translation>Ce qui peut être faux</translation>
    </message>
    <message>
        <source>Of the plant before the last edits: it is computed anew</source>
        <translation>De la plante avant les dernières modifications&#xa0;: la part est recalculée</translation>
    </message>
    <message>
        <source>%1  %2 · %3 %</source>
        <translation>%1  %2 · %3 %</translation>
    </message>
    <message>
        <source>Correct it with any tool; %1 goes on</source>
        <translation>Corrigez-le avec n’importe quel outil&#xa0;; %1 continue</translation>
    </message>
</context>
<context>
    <name>espalier::SweepCard</name>
    <message>
        <source>is computed</source>
        <translation>en cours de calcul</translation>
    </message>
    <message>
        <source>%1 %2, best</source>
        <translation>%1 %2, le meilleur</translation>
    </message>
    <message>
        <source>set</source>
        <translation>réglé</translation>
    </message>
    <message>
        <source>%1 %2 is set</source>
        <translation>%1 %2 est réglé</translation>
    </message>
    <message>
        <source>Click to set %1 %2</source>
        <translation>Cliquez pour régler %1 %2</translation>
    </message>
</context>
<context>
    <name>espalier::SweepFlow</name>
    <message>
        <source>Sweep</source>
        <translation>Balayage</translation>
    </message>
    <message>
        <source>Sweep of a Parameter</source>
        <translation>Balayage d’un paramètre</translation>
    </message>
    <message>
        <source>Shows or hides what comes of several values of one option</source>
        <translation>Affiche ou masque ce que donnent plusieurs valeurs d’une option</translation>
    </message>
    <message>
        <source>Option that is swept</source>
        <translation>Option balayée</translation>
    </message>
    <message>
        <source>How many values</source>
        <translation>Combien de valeurs</translation>
    </message>
    <message>
        <source> values</source>
        <translation> valeurs</translation>
    </message>
    <message>
        <source>from</source>
        <translation>de</translation>
    </message>
    <message>
        <source>The least value</source>
        <translation>La plus petite valeur</translation>
    </message>
    <message>
        <source>to</source>
        <translation>à</translation>
    </message>
    <message>
        <source>The greatest value</source>
        <translation>La plus grande valeur</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lancer</translation>
    </message>
    <message>
        <source>Reconstructs the plant with each value; nothing of it changes</source>
        <translation>Reconstruit la plante avec chaque valeur&#xa0;; elle-même ne change en rien</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Tries values of one option; a click takes one</source>
        <translation>Essaie des valeurs d’une option&#xa0;; un clic en prend une</translation>
    </message>
    <message>
        <source>Sweep of %1</source>
        <translation>Balayage de %1</translation>
    </message>
    <message>
        <source>The middle of the view.</source>
        <translation>Le milieu de la vue.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>step, option</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 to %2 values</source>
        <translation>%1 à %2 valeurs</translation>
    </message>
    <message>
        <source>%1, as set</source>
        <translation>%1, tel que réglé</translation>
    </message>
    <message>
        <source>%1: stopped, %2 of %3 done</source>
        <translation>%1&#xa0;: arrêté, %2 sur %3 faits</translation>
    </message>
    <message>
        <source>%1: %2 of %3 done</source>
        <translation>%1&#xa0;: %2 sur %3 faits</translation>
    </message>
    <message>
        <source>Set: %1 %2   {reconstruct} make the plant with it</source>
        <translation>Réglé&#xa0;: %1 %2   {reconstruct} refaire la plante ainsi</translation>
    </message>
</context>
<context>
    <name>espalier::SweepStrip</name>
    <message>
        <source>Sweep</source>
        <translation>Balayage</translation>
    </message>
</context>
<context>
    <name>espalier::ThemeFlow</name>
    <message>
        <source>Theme</source>
        <translation>Thème</translation>
    </message>
    <message>
        <source>Changes the colors of the window</source>
        <translation>Change les couleurs de la fenêtre</translation>
    </message>
    <message>
        <source>As the System</source>
        <translation>Comme le système</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Lumière</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
</context>
<context>
    <name>espalier::TourFlow</name>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Tour in Three Steps</source>
        <translation>Visite en trois étapes</translation>
    </message>
    <message>
        <source>Shows where the skeleton is found, what is in doubt, and how to sign</source>
        <translation>Montre où trouver le squelette, ce qui est douteux et comment signer</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Étape %1 sur %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fait</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Find the skeleton: press Reconstruct, or %1.</source>
        <translation>Trouver le squelette&#xa0;: appuyez sur Reconstruire, ou sur %1.</translation>
    </message>
    <message>
        <source>Look at what is in doubt: %1 asks about what the program is not sure of, %2 goes to places that look wrong.</source>
        <translation>Regarder ce qui est douteux&#xa0;: %1 pose des questions sur ce dont le programme n’est pas sûr, %2 va aux endroits qui semblent faux.</translation>
    </message>
    <message>
        <source>Sign: %1 opens the review. It shows the plant part by part; Enter marks what is right. Sign Structure… then seals it.</source>
        <translation>Signer&#xa0;: %1 ouvre la révision. Elle montre la plante partie par partie&#xa0;; Entrée marque ce qui est juste. Signer la structure… la scelle ensuite.</translation>
    </message>
</context>
<context>
    <name>espalier::TourHint</name>
    <message>
        <source>Leave the Tour</source>
        <translation>Quitter la visite</translation>
    </message>
</context>
<context>
    <name>espalier::TraceFlow</name>
    <message>
        <source>all points are set aside: bring some back</source>
        <translation>tous les points sont mis de côté&#xa0;: reprenez-en</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Show Another Path</source>
        <translation>Montrer un autre chemin</translation>
    </message>
    <message>
        <source>The next path that a trace could take</source>
        <translation>Le chemin suivant que le tracé pourrait prendre</translation>
    </message>
    <message>
        <source>Regrow What Is Missing</source>
        <translation>Reconstruire ce qui manque</translation>
    </message>
    <message>
        <source>Grows branches from all points that the skeleton does not explain</source>
        <translation>Reconstruit des branches à partir de tous les points que le squelette n’explique pas</translation>
    </message>
    <message>
        <source>New Branch from Points</source>
        <translation>Nouvelle branche à partir des points</translation>
    </message>
    <message>
        <source>Grows a branch from the selected points, on the nearest node</source>
        <translation>Reconstruit une branche à partir des points sélectionnés, sur le nœud le plus proche</translation>
    </message>
    <message>
        <source>Only Longer Branches</source>
        <translation>Seulement les plus longues</translation>
    </message>
    <message>
        <source>Leaves the shortest fifth out of the branches that are shown to be added</source>
        <translation>Écarte le cinquième le plus court des branches dont l’ajout est proposé</translation>
    </message>
    <message>
        <source>Shorter Branches Too</source>
        <translation>Aussi les plus courtes</translation>
    </message>
    <message>
        <source>Shows a fifth more branches to be added, the longest of the others</source>
        <translation>Montre un cinquième de branches à ajouter en plus, les plus longues des autres</translation>
    </message>
    <message>
        <source>Take This Branch</source>
        <translation>Prendre cette branche</translation>
    </message>
    <message>
        <source>Takes the branch that is proposed, and goes on to the next</source>
        <translation>Prend la branche proposée, et passe à la suivante</translation>
    </message>
    <message>
        <source>Drop This Branch</source>
        <translation>Abandonner cette branche</translation>
    </message>
    <message>
        <source>Leaves out the branch that is proposed and what it would carry, and goes on to the next</source>
        <translation>Écarte la branche proposée et ce qu’elle porterait, et passe à la suivante</translation>
    </message>
    <message>
        <source>Tracing</source>
        <translation>Tracé</translation>
    </message>
    <message>
        <source>Reading the points</source>
        <translation>Lecture des points</translation>
    </message>
    <message>
        <source>there are no points to regrow from: open the scan first</source>
        <translation>il n’y a pas de points pour reconstruire à nouveau&#xa0;: ouvrez d’abord le scan</translation>
    </message>
    <message>
        <source>Regrowing</source>
        <translation>Reconstruction à nouveau</translation>
    </message>
    <message>
        <source>Growing what is missing</source>
        <translation>Reconstruction de ce qui manque</translation>
    </message>
    <message>
        <source>Regrow what is missing</source>
        <translation>Reconstruire ce qui manque</translation>
    </message>
    <message>
        <source>no point is selected: choose Select Points (C), and paint some</source>
        <translation>aucun point n’est sélectionné&#xa0;: choisissez Sélectionner des points (C), et peignez-en quelques-uns</translation>
    </message>
    <message>
        <source>Growing a branch</source>
        <translation>Reconstruction d’une branche</translation>
    </message>
    <message>
        <source>New branch from points</source>
        <translation>Nouvelle branche à partir des points</translation>
    </message>
    <message>
        <source>The plant was edited meanwhile: regrow the branch again</source>
        <translation>La plante a été modifiée entre-temps&#xa0;: reconstruisez la branche à nouveau</translation>
    </message>
</context>
<context>
    <name>espalier::TraceTool</name>
    <message>
        <source>There are no points to trace along: open the scan first</source>
        <translation>Il n’y a pas de points le long desquels tracer&#xa0;: ouvrez d’abord le scan</translation>
    </message>
    <message>
        <source>Click where the branch starts: a node, an edge or a point</source>
        <translation>Cliquer là où la branche commence&#xa0;: un nœud, une arête ou un point</translation>
    </message>
    <message>
        <source>Reading the points, %1 %   Esc: drop</source>
        <translation>Lecture des points, %1&#xa0;%   Échap&#xa0;: abandonner</translation>
    </message>
    <message>
        <source>A branch cannot end in its own tree: end it on a point   Esc: drop</source>
        <translation>Une branche ne peut pas finir dans son propre arbre&#xa0;: terminez-la sur un point   Échap&#xa0;: abandonner</translation>
    </message>
    <message>
        <source>Click: end it here   Enter accepts, Esc drops   Drag: turn</source>
        <translation>Cliquer&#xa0;: la terminer ici   Entrée accepte, Échap abandonne   Glisser&#xa0;: tourner</translation>
    </message>
    <message>
        <source>Path %1 of %2   Tab: next path   Enter accepts, Esc drops</source>
        <translation>Chemin %1 sur %2   Tab&#xa0;: chemin suivant   Entrée accepte, Échap abandonne</translation>
    </message>
    <message>
        <source>Enter accepts, Esc drops   Click: end it elsewhere</source>
        <translation>Entrée accepte, Échap abandonne   Cliquer&#xa0;: la terminer ailleurs</translation>
    </message>
    <message>
        <source>Point along the branch, and click its end   Drag: turn   Esc: drop</source>
        <translation>Pointer le long de la branche, et cliquer son extrémité   Glisser&#xa0;: tourner   Échap&#xa0;: abandonner</translation>
    </message>
    <message>
        <source>there are no points to trace along: open the scan first</source>
        <translation>il n’y a pas de points le long desquels tracer&#xa0;: ouvrez d’abord le scan</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>path</comment>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>%1 is of the same tree, the branch would be a loop: end it on a point, or cut %1 first</source>
        <translation>%1 est du même arbre, la branche ferait une boucle&#xa0;: terminez-la sur un point, ou coupez d’abord %1</translation>
    </message>
    <message>
        <source>the node it was attached to is gone: trace it again</source>
        <translation>le nœud auquel elle était attachée a disparu&#xa0;: tracez-la à nouveau</translation>
    </message>
    <message>
        <source>Trace a branch from %1</source>
        <translation>Tracer une branche depuis %1</translation>
    </message>
    <message>
        <source>Trace a branch</source>
        <translation>Tracer une branche</translation>
    </message>
</context>
<context>
    <name>espalier::TraitsFlow</name>
    <message>
        <source>Measure Light</source>
        <translation>Mesurer la lumière</translation>
    </message>
    <message>
        <source>Measures how much of its surface the plant shows to an overcast sky: the silhouette to total area ratio (STAR)</source>
        <translation>Mesure quelle part de sa surface la plante montre à un ciel couvert&#xa0;: le rapport de la silhouette à la surface totale (STAR)</translation>
    </message>
    <message>
        <source>Export Report of the Plant…</source>
        <translation>Exporter le rapport de la plante…</translation>
    </message>
    <message>
        <source>Writes traits, wood and light of the plant by itself: with pictures as HTML or PDF, or all numbers as CSV or JSON</source>
        <translation>Écrit les traits, le bois et la lumière de la plante seule&#xa0;: avec des images en HTML ou PDF, ou tous les nombres en CSV ou JSON</translation>
    </message>
    <message>
        <source>the density of the wood in this project cannot be read: type it again</source>
        <translation>la densité du bois dans ce projet ne peut pas être lue&#xa0;: saisissez-la à nouveau</translation>
    </message>
    <message>
        <source>Measuring light</source>
        <translation>Mesure de la lumière</translation>
    </message>
    <message>
        <source>the plant has no radii, and so no surface that light falls on: estimate radii first</source>
        <translation>la plante n’a pas de rayons, et donc pas de surface où tombe la lumière&#xa0;: estimez d’abord les rayons</translation>
    </message>
    <message>
        <source>The plant was changed while its light was measured: measure it again</source>
        <translation>La plante a été modifiée pendant la mesure de sa lumière&#xa0;: mesurez-la à nouveau</translation>
    </message>
    <message>
        <source>The plant shows %1 of its surface to an overcast sky (STAR)</source>
        <translation>La plante montre %1 de sa surface à un ciel couvert (STAR)</translation>
    </message>
    <message>
        <source>Export the report of the plant</source>
        <translation>Exporter le rapport de la plante</translation>
    </message>
    <message>
        <source>Web pages (*.html);;PDF (*.pdf);;Tables (*.csv);;JSON (*.json)</source>
        <translation>Pages web (*.html);;PDF (*.pdf);;Tableaux (*.csv);;JSON (*.json)</translation>
    </message>
    <message>
        <source>Measuring for the report</source>
        <translation>Mesures pour le rapport</translation>
    </message>
</context>
<context>
    <name>espalier::TraitsPanel</name>
    <message>
        <source>Traits of the plant</source>
        <translation>Traits de la plante</translation>
    </message>
    <message>
        <source>The plant by itself</source>
        <translation>La plante seule</translation>
    </message>
    <message>
        <source>Density of the wood</source>
        <translation>Densité du bois</translation>
    </message>
    <message>
        <source>Wood </source>
        <translation>Bois </translation>
    </message>
    <message>
        <source>Dry mass of a cubic meter of wood, for biomass; none is assumed. The unit of the plant must be known</source>
        <translation>Masse sèche d’un mètre cube de bois, pour la biomasse&#xa0;; aucune n’est supposée. L’unité de la plante doit être connue</translation>
    </message>
    <message>
        <source>Wood: no density</source>
        <translation>Bois&#xa0;: aucune densité</translation>
    </message>
    <message>
        <source>Measure Light</source>
        <translation>Mesurer la lumière</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Rapport…</translation>
    </message>
    <message>
        <source>Load Reference…</source>
        <translation>Charger la référence…</translation>
    </message>
    <message>
        <source>Reconstruct the scan, or open a structure: its traits are shown here.
Load a reference to see how the two agree.</source>
        <translation>Reconstruisez le scan, ou ouvrez une structure&#xa0;: ses traits sont affichés ici.
Chargez une référence pour voir comment les deux s’accordent.</translation>
    </message>
    <message>
        <source>Of the plant before it was changed: measure it again</source>
        <translation>De la plante avant sa modification&#xa0;: mesurez-la à nouveau</translation>
    </message>
    <message>
        <source>Axes by order</source>
        <translation>Axes par ordre</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordre</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <source>Mean length</source>
        <translation>Longueur moyenne</translation>
    </message>
    <message>
        <source>Leave at</source>
        <translation>Départ à</translation>
    </message>
    <message>
        <source>Branching angle</source>
        <translation>Angle de ramification</translation>
    </message>
    <message>
        <source>How many branchings lie between the axis and the root</source>
        <translation>Combien de ramifications il y a entre l’axe et la racine</translation>
    </message>
    <message>
        <source>How many there are</source>
        <translation>Combien il y en a</translation>
    </message>
    <message>
        <source>Along the axis</source>
        <translation>Le long de l’axe</translation>
    </message>
    <message>
        <source>Where on what bears them: 0 at its foot, 1 at its tip</source>
        <translation>Où, sur ce qui les porte&#xa0;: 0 à son pied, 1 à son extrémité</translation>
    </message>
    <message>
        <source>Mean, between branches of this order and what bears them</source>
        <translation>Moyenne, entre les branches de cet ordre et ce qui les porte</translation>
    </message>
    <message>
        <source>%1, order %2</source>
        <translation>%1, ordre %2</translation>
    </message>
    <message>
        <source>over %1</source>
        <translation>plus de %1</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>jusqu’à %1</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diamètre</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Classe</translation>
    </message>
    <message>
        <source>Wood by order</source>
        <translation>Bois par ordre</translation>
    </message>
    <message>
        <source>Wood by diameter</source>
        <translation>Bois par diamètre</translation>
    </message>
    <message>
        <source>Wood by class, scale %1</source>
        <translation>Bois par classe, échelle %1</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Biomass</source>
        <translation>Biomasse</translation>
    </message>
    <message>
        <source>%1, %2 %3</source>
        <translation>%1, %2 %3</translation>
    </message>
    <message>
        <source> kg</source>
        <translation> kg</translation>
    </message>
</context>
<context>
    <name>espalier::TurntableFlow</name>
    <message>
        <source>Save Turntable…</source>
        <translation>Enregistrer une rotation…</translation>
    </message>
    <message>
        <source>Writes a movie of the plant, as the view shows it, turning once about its pivot</source>
        <translation>Écrit un film de la plante, telle que la vue la montre, qui fait un tour autour de son pivot</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source> pixels</source>
        <translation> pixels</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>One turn takes</source>
        <translation>Durée d’un tour</translation>
    </message>
    <message>
        <source>Choose File</source>
        <translation>Choisir le fichier</translation>
    </message>
    <message>
        <source>Save the turntable</source>
        <translation>Enregistrer la rotation</translation>
    </message>
    <message>
        <source>Animated PNG (*.png)</source>
        <translation>PNG animé (*.png)</translation>
    </message>
    <message>
        <source>%1: movies are written as animated PNG: choose a name that ends in .png</source>
        <translation>%1 : les films sont écrits en PNG animé : choisissez un nom qui finit par .png</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>Écriture de %1</translation>
    </message>
    <message>
        <source>Wrote %1: %2 pictures, %3 MB</source>
        <translation>%1 écrit&#xa0;: %2 images, %3 Mo</translation>
    </message>
</context>
<context>
    <name>espalier::TwoViewsFlow</name>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Two Views</source>
        <translation>Deux vues</translation>
    </message>
    <message>
        <source>Shows the plant from another side as well</source>
        <translation>Montre la plante aussi d’un autre côté</translation>
    </message>
    <message>
        <source>From the Side</source>
        <translation>De côté</translation>
    </message>
    <message>
        <source>The second view looks at a right angle to the first, and moves with it</source>
        <translation>La seconde vue regarde à angle droit de la première, et bouge avec elle</translation>
    </message>
    <message>
        <source>Same Direction</source>
        <translation>Même direction</translation>
    </message>
    <message>
        <source>The second view looks as the first, and moves with it</source>
        <translation>La seconde vue regarde comme la première, et bouge avec elle</translation>
    </message>
    <message>
        <source>Not Linked</source>
        <translation>Non liées</translation>
    </message>
    <message>
        <source>Each view is moved by itself</source>
        <translation>Chaque vue est déplacée seule</translation>
    </message>
    <message>
        <source>All of the Plant</source>
        <translation>Toute la plante</translation>
    </message>
    <message>
        <source>The second view keeps all of the plant in sight; Look Closely in it shows a part of it in the first</source>
        <translation>La seconde vue garde toute la plante visible&#xa0;; Vue rapprochée y montre une partie de celle-ci dans la première</translation>
    </message>
    <message>
        <source>Second view of the plant</source>
        <translation>Seconde vue de la plante</translation>
    </message>
</context>
<context>
    <name>espalier::UnitFlow</name>
    <message>
        <source>Units</source>
        <translation>Unités</translation>
    </message>
    <message>
        <source>Commit Marks to a Scale…</source>
        <translation>Convertir les marques en échelle…</translation>
    </message>
    <message>
        <source>Makes units of a new scale, one from each mark</source>
        <translation>Fait les unités d’une nouvelle échelle, une par marque</translation>
    </message>
    <message>
        <source>Clear Marks</source>
        <translation>Effacer les marques</translation>
    </message>
    <message>
        <source>Takes all marks of unit starts off</source>
        <translation>Retire toutes les marques de débuts d’unité</translation>
    </message>
    <message>
        <source>Commit the marks to %1</source>
        <translation>Convertir les marques en %1</translation>
    </message>
    <message>
        <source>Clear the marks</source>
        <translation>Effacer les marques</translation>
    </message>
    <message>
        <source>Add a Feature to %1</source>
        <translation>Ajouter un attribut à %1</translation>
    </message>
    <message>
        <source>Add the feature %1 to %2</source>
        <translation>Ajouter l’attribut %1 à %2</translation>
    </message>
    <message>
        <source>Add a Date to %1</source>
        <translation>Ajouter une date à %1</translation>
    </message>
    <message>
        <source>Add a date to %1</source>
        <translation>Ajouter une date à %1</translation>
    </message>
    <message>
        <source>{mark_unit_start} mark unit start</source>
        <translation>{mark_unit_start} marquer un début d’unité</translation>
    </message>
    <message>
        <source>%1 marked</source>
        <translation>marques&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>espalier::UnitsForm</name>
    <message>
        <source>Of type %1</source>
        <translation>De type %1</translation>
    </message>
    <message>
        <source>Set %1 of %2</source>
        <translation>Définir %1 de %2</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Classe</translation>
    </message>
    <message>
        <source>Letters alone</source>
        <translation>Seulement des lettres</translation>
    </message>
    <message>
        <source>Set the class of %1</source>
        <translation>Définir la classe&#xa0;: %1</translation>
    </message>
    <message>
        <source>Index</source>
        <translation>Indice</translation>
    </message>
    <message>
        <source>A whole number, two parted by a dot (16.1), or nothing</source>
        <translation>Un nombre entier, deux séparés par un point (16.1), ou rien</translation>
    </message>
    <message>
        <source>Set the index of %1</source>
        <translation>Définir l’indice&#xa0;: %1</translation>
    </message>
    <message>
        <source>Alias</source>
        <translation>Alias</translation>
    </message>
    <message>
        <source>Its name in the file, or nothing</source>
        <translation>Son nom dans le fichier, ou rien</translation>
    </message>
    <message>
        <source>Set the alias of %1</source>
        <translation>Définir l’alias&#xa0;: %1</translation>
    </message>
    <message>
        <source>At %1</source>
        <translation>Au %1</translation>
    </message>
    <message>
        <source>At later date %1</source>
        <translation>À la date ultérieure %1</translation>
    </message>
    <message>
        <source>As %1, scale %2</source>
        <translation>En tant que %1, échelle %2</translation>
    </message>
    <message>
        <source>In %1, scale %2</source>
        <translation>Dans %1, échelle %2</translation>
    </message>
    <message>
        <source>No features yet</source>
        <translation>Pas encore d’attributs</translation>
    </message>
    <message>
        <source>node %1</source>
        <translation>nœud %1</translation>
    </message>
    <message>
        <source>End %1 at node %2</source>
        <translation>Finir %1 au nœud %2</translation>
    </message>
    <message>
        <source>Begin a unit like %1 at node %2</source>
        <translation>Commencer une unité comme %1 au nœud %2</translation>
    </message>
    <message>
        <source>begins here</source>
        <translation>commence ici</translation>
    </message>
    <message>
        <source>Add feature…</source>
        <translation>Nouvel attribut…</translation>
    </message>
    <message>
        <source>Declares a feature that the file does not have yet</source>
        <translation>Déclare un attribut que le fichier n’a pas encore</translation>
    </message>
    <message>
        <source>Add date…</source>
        <translation>Nouvelle date…</translation>
    </message>
    <message>
        <source>Adds values of a later date</source>
        <translation>Ajoute des valeurs d’une date ultérieure</translation>
    </message>
</context>
<context>
    <name>espalier::ValueColors</name>
    <message>
        <source>Review</source>
        <translation>Révision</translation>
    </message>
    <message>
        <source>To the surface</source>
        <translation>À la surface</translation>
    </message>
    <message>
        <source>Organ</source>
        <translation>Organe</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>Bois</translation>
    </message>
    <message>
        <source>Petiole</source>
        <translation>Pétiole</translation>
    </message>
    <message>
        <source>Blade</source>
        <translation>Limbe</translation>
    </message>
    <message>
        <source>Needle</source>
        <translation>Aiguille</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>Déplacement</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordre</translation>
    </message>
    <message>
        <source>Radius / parent&apos;s</source>
        <translation>Rayon / celui du parent</translation>
    </message>
    <message>
        <source>Scanned</source>
        <translation>Scanné</translation>
    </message>
    <message>
        <source>Radius ±</source>
        <translation>Rayon ±</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>To its points</source>
        <translation>À ses points</translation>
    </message>
</context>
<context>
    <name>espalier::VersionsFlow</name>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>&amp;Name This Version…</source>
        <translation>&amp;Nommer cette version…</translation>
    </message>
    <message>
        <source>Keeps the skeleton as it is now in the project, under a name</source>
        <translation>Garde dans le projet le squelette tel qu’il est, sous un nom</translation>
    </message>
    <message>
        <source>&amp;Compare With Version…</source>
        <translation>&amp;Comparer à une version…</translation>
    </message>
    <message>
        <source>Compares the plant with a version that was named, or the end of a day before</source>
        <translation>Compare la plante à une version nommée, ou à la fin d’un jour précédent</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>there is no skeleton to keep: make one first</source>
        <translation>il n’y a pas de squelette à garder&#xa0;: faites-en un d’abord</translation>
    </message>
    <message>
        <source>only a project keeps versions: save the plant as one first</source>
        <translation>seul un projet garde des versions&#xa0;: enregistrez d’abord la plante comme projet</translation>
    </message>
    <message>
        <source>Version %1</source>
        <translation>Version %1</translation>
    </message>
    <message>
        <source>Name This Version</source>
        <translation>Nommer cette version</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Nom&#xa0;:</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Garder</translation>
    </message>
    <message>
        <source>a version needs a name</source>
        <translation>une version doit avoir un nom</translation>
    </message>
    <message>
        <source>the end of %1</source>
        <translation>la fin de %1</translation>
    </message>
    <message>
        <source>the reconstruction, before work by hand</source>
        <translation>la reconstruction, avant le travail à la main</translation>
    </message>
    <message>
        <source>what was opened, before any edit</source>
        <translation>ce qui a été ouvert, avant toute modification</translation>
    </message>
    <message>
        <source>there is no skeleton to compare: make one first</source>
        <translation>il n’y a pas de squelette à comparer&#xa0;: faites-en un d’abord</translation>
    </message>
    <message>
        <source>there is no other state of this plant yet: name this version before you go on</source>
        <translation>il n’y a pas encore d’autre état de cette plante&#xa0;: nommez cette version avant de continuer</translation>
    </message>
    <message>
        <source>Compare With Version</source>
        <translation>Comparer à une version</translation>
    </message>
    <message>
        <source>Compare the plant as it is now with:</source>
        <translation>Comparer la plante telle qu’elle est maintenant à&#xa0;:</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Rien pour l’instant</translation>
    </message>
    <message>
        <source>The project no longer keeps %1</source>
        <translation>Le projet ne garde plus %1</translation>
    </message>
    <message>
        <source>Keep It</source>
        <translation>La garder</translation>
    </message>
    <message>
        <source>The project keeps this state as “%1”</source>
        <translation>Le projet garde cet état sous le nom «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>espalier::VertexModel</name>
    <message>
        <source>at later date %1</source>
        <translation>à la date ultérieure %1</translation>
    </message>
    <message>
        <source>Of type %1</source>
        <translation>De type %1</translation>
    </message>
    <message>
        <source>The vertex that carries it: &lt; it follows that, + it branches off</source>
        <translation>Le sommet qui le porte&#xa0;: &lt; il le continue, + il s’y ramifie</translation>
    </message>
    <message>
        <source>Vertex</source>
        <translation>Sommet</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Attached to</source>
        <translation>Attaché à</translation>
    </message>
</context>
<context>
    <name>espalier::VertexPage</name>
    <message>
        <source>Vertices</source>
        <translation>Sommets</translation>
    </message>
    <message>
        <source>%1 has no positions</source>
        <translation>%1 n’a pas de positions</translation>
    </message>
    <message>
        <source>It describes a plant without its shape, so there is nothing to see in space. Its scales and features are below; %1 writes it as MTG or OPF. To see the plant, give the vertices of one scale the features XX, YY and ZZ in the file, and open it again.</source>
        <translation>Il décrit une plante sans sa forme, il n’y a donc rien à voir dans l’espace. Ses échelles et attributs sont ci-dessous&#xa0;; %1 l’écrit en MTG ou OPF. Pour voir la plante, donnez dans le fichier aux sommets d’une échelle les attributs XX, YY et ZZ, et ouvrez-le à nouveau.</translation>
    </message>
    <message>
        <source>Scale %1: %2</source>
        <translation>Échelle %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Edges: %1 &lt;, %2 +</source>
        <translation>Arêtes&#xa0;: %1 &lt;, %2 +</translation>
    </message>
</context>
<context>
    <name>espalier::ViewMoves</name>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Turns the plant by 15 degrees</source>
        <translation>Tourne la plante de 15 degrés</translation>
    </message>
    <message>
        <source>Turn Left</source>
        <translation>Tourner à gauche</translation>
    </message>
    <message>
        <source>Turn Right</source>
        <translation>Tourner à droite</translation>
    </message>
    <message>
        <source>Turn Up</source>
        <translation>Tourner vers le haut</translation>
    </message>
    <message>
        <source>Turn Down</source>
        <translation>Tourner vers le bas</translation>
    </message>
    <message>
        <source>Moves the plant by a tenth of the height of the view</source>
        <translation>Déplace la plante d’un dixième de la hauteur de la vue</translation>
    </message>
    <message>
        <source>Move Left</source>
        <translation>Déplacer à gauche</translation>
    </message>
    <message>
        <source>Move Right</source>
        <translation>Déplacer à droite</translation>
    </message>
    <message>
        <source>Move Up</source>
        <translation>Déplacer vers le haut</translation>
    </message>
    <message>
        <source>Move Down</source>
        <translation>Déplacer vers le bas</translation>
    </message>
    <message>
        <source>Zoom In</source>
        <translation>Agrandir</translation>
    </message>
    <message>
        <source>Shows the middle of the view larger by a quarter</source>
        <translation>Montre le milieu de la vue plus grand d’un quart</translation>
    </message>
    <message>
        <source>Zoom Out</source>
        <translation>Réduire</translation>
    </message>
    <message>
        <source>Shows the middle of the view smaller by as much</source>
        <translation>Montre le milieu de la vue plus petit d’autant</translation>
    </message>
</context>
<context>
    <name>espalier::ViewOptions</name>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Calques</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Shows the scan</source>
        <translation>Affiche le scan</translation>
    </message>
    <message>
        <source>Contracted Points</source>
        <translation>Points contractés</translation>
    </message>
    <message>
        <source>Shows where contraction has moved the points</source>
        <translation>Affiche où la contraction a déplacé les points</translation>
    </message>
    <message>
        <source>Skeleton</source>
        <translation>Squelette</translation>
    </message>
    <message>
        <source>Shows nodes and edges</source>
        <translation>Affiche les nœuds et les arêtes</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Référence</translation>
    </message>
    <message>
        <source>Shows the structure that the skeleton is compared with</source>
        <translation>Affiche la structure à laquelle le squelette est comparé</translation>
    </message>
    <message>
        <source>True Radii</source>
        <translation>Rayons réels</translation>
    </message>
    <message>
        <source>Draws edges as thick as the wood</source>
        <translation>Trace les arêtes aussi épaisses que le bois</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Draws points of this size</source>
        <translation>Trace les points à cette taille</translation>
    </message>
    <message>
        <source>Point Size %1 px</source>
        <translation>Taille des points %1 px</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspective</translation>
    </message>
    <message>
        <source>Near things are larger</source>
        <translation>Ce qui est proche est plus grand</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Parallèle</translation>
    </message>
    <message>
        <source>Equal lengths look equal</source>
        <translation>Des longueurs égales paraissent égales</translation>
    </message>
    <message>
        <source>Minimap</source>
        <translation>Vue d’ensemble</translation>
    </message>
    <message>
        <source>Shows all of the plant in a corner, to move about in it</source>
        <translation>Montre toute la plante dans un coin, pour s’y déplacer</translation>
    </message>
    <message>
        <source>Looks from there</source>
        <translation>Regarde de là</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Arrière</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Dessus</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Dessous</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isométrique</translation>
    </message>
    <message>
        <source>Frame All</source>
        <translation>Cadrer tout</translation>
    </message>
    <message>
        <source>The whole plant fills the view</source>
        <translation>La plante entière remplit la vue</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Colors points by their height</source>
        <translation>Colore les points selon leur hauteur</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>Intensité</translation>
    </message>
    <message>
        <source>Colors points by the strength of the echo</source>
        <translation>Colore les points selon la force de l’écho</translation>
    </message>
    <message>
        <source>Own Color</source>
        <translation>Couleur propre</translation>
    </message>
    <message>
        <source>Colors points as the scanner saw them</source>
        <translation>Colore les points comme le scanner les a vus</translation>
    </message>
    <message>
        <source>One Color</source>
        <translation>Une seule couleur</translation>
    </message>
    <message>
        <source>Draws all points alike</source>
        <translation>Trace tous les points de la même façon</translation>
    </message>
    <message>
        <source>Distance to Skeleton</source>
        <translation>Distance au squelette</translation>
    </message>
    <message>
        <source>Colors points by how far they are from the surface of the wood</source>
        <translation>Colore les points selon leur distance à la surface du bois</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>Déplacement</translation>
    </message>
    <message>
        <source>Colors points by how far contraction moves them</source>
        <translation>Colore les points selon le déplacement que leur donne la contraction</translation>
    </message>
    <message>
        <source>Organ</source>
        <translation>Organe</translation>
    </message>
    <message>
        <source>Finds what points lie on, wood, petiole, blade or needle, and colors them by it</source>
        <translation>Trouve sur quoi sont les points, bois, pétiole, limbe ou aiguille, et les colore en conséquence</translation>
    </message>
    <message>
        <source>Type of Edge</source>
        <translation>Type d’arête</translation>
    </message>
    <message>
        <source>Draws nodes and edges as usual</source>
        <translation>Trace les nœuds et les arêtes comme d’habitude</translation>
    </message>
    <message>
        <source>Distance to Points</source>
        <translation>Distance aux points</translation>
    </message>
    <message>
        <source>Colors nodes by how far their points are from the surface of the wood</source>
        <translation>Colore les nœuds selon la distance de leurs points à la surface du bois</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordre</translation>
    </message>
    <message>
        <source>Colors nodes by the branchings below them</source>
        <translation>Colore les nœuds selon le nombre de ramifications au-dessous d’eux</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Colors nodes by their radius</source>
        <translation>Colore les nœuds selon leur rayon</translation>
    </message>
    <message>
        <source>Radius against Parent&apos;s</source>
        <translation>Rayon par rapport au parent</translation>
    </message>
    <message>
        <source>Colors nodes by their radius as a share of their parent&apos;s</source>
        <translation>Colore les nœuds selon leur rayon, en part de celui de leur parent</translation>
    </message>
    <message>
        <source>Uncertainty of Radius</source>
        <translation>Incertitude du rayon</translation>
    </message>
    <message>
        <source>Colors nodes by how wide the interval is in which their radius lies</source>
        <translation>Colore les nœuds selon la largeur de l’intervalle où est leur rayon</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Confiance</translation>
    </message>
    <message>
        <source>Colors nodes by how much of their surface has points</source>
        <translation>Colore les nœuds selon la part de leur surface qui a des points</translation>
    </message>
    <message>
        <source>Review State</source>
        <translation>État de révision</translation>
    </message>
    <message>
        <source>Colors nodes by what the review says</source>
        <translation>Colore les nœuds selon ce que dit la révision</translation>
    </message>
    <message>
        <source>Comparison with Reference</source>
        <translation>Comparaison à la référence</translation>
    </message>
    <message>
        <source>Colors skeleton and reference by what is matched, missed, invented or wrongly attached</source>
        <translation>Colore le squelette et la référence selon ce qui est apparié, manqué, inventé ou mal attaché</translation>
    </message>
    <message>
        <source>Viridis</source>
        <translation>Viridis</translation>
    </message>
    <message>
        <source>Cividis</source>
        <translation>Cividis</translation>
    </message>
    <message>
        <source>Gray</source>
        <translation>Gris</translation>
    </message>
    <message>
        <source>Colors of the values of points</source>
        <translation>Couleurs des valeurs des points</translation>
    </message>
    <message>
        <source>Colors of the values of nodes</source>
        <translation>Couleurs des valeurs des nœuds</translation>
    </message>
    <message>
        <source>Type Color Range…</source>
        <translation>Saisir la plage de couleurs…</translation>
    </message>
    <message>
        <source>Types the values at the ends of the color bar</source>
        <translation>Saisit les valeurs aux extrémités de la barre de couleurs</translation>
    </message>
    <message>
        <source>color points or nodes by a value first</source>
        <translation>colorez d’abord les points ou les nœuds selon une valeur</translation>
    </message>
    <message>
        <source>Usual Color Ranges</source>
        <translation>Plages de couleurs habituelles</translation>
    </message>
    <message>
        <source>Gives all color bars the range that follows from the values</source>
        <translation>Donne à toutes les barres de couleurs la plage qui découle des valeurs</translation>
    </message>
    <message>
        <source>Colors Span What Is Seen</source>
        <translation>Couleurs selon ce qui est vu</translation>
    </message>
    <message>
        <source>Close up, heights and intensities of the points that are seen take all colors</source>
        <translation>De près, les hauteurs et intensités des points vus prennent toutes les couleurs</translation>
    </message>
    <message>
        <source>Red-Cyan Stereo</source>
        <translation>Stéréo rouge-cyan</translation>
    </message>
    <message>
        <source>Draws the plant for each eye, for glasses of red and cyan</source>
        <translation>Dessine la plante pour chaque œil, pour des lunettes rouge et cyan</translation>
    </message>
</context>
<context>
    <name>espalier::WorklistFlow</name>
    <message>
        <source>Worklist</source>
        <translation>Liste de travail</translation>
    </message>
    <message>
        <source>Shows or hides the plants of a folder or table, and how far each is</source>
        <translation>Affiche ou masque les plantes d’un dossier ou d’un tableau, et où chacune en est</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Worklist of a Folder…</source>
        <translation>Liste de travail d’un dossier…</translation>
    </message>
    <message>
        <source>Lists the projects and scans of a folder, to work on one after another</source>
        <translation>Liste les projets et scans d’un dossier, pour travailler sur l’un après l’autre</translation>
    </message>
    <message>
        <source>Worklist of a Table…</source>
        <translation>Liste de travail d’un tableau…</translation>
    </message>
    <message>
        <source>Lists the plants that a CSV table names, to work on one after another</source>
        <translation>Liste les plantes que nomme un tableau CSV, pour travailler sur l’une après l’autre</translation>
    </message>
    <message>
        <source>Next Plant of the Worklist</source>
        <translation>Plante suivante de la liste de travail</translation>
    </message>
    <message>
        <source>Opens the next plant of the worklist that is not signed</source>
        <translation>Ouvre la plante suivante de la liste de travail qui n’est pas signée</translation>
    </message>
    <message>
        <source>Compare With Second Annotator</source>
        <translation>Comparer au second annotateur</translation>
    </message>
    <message>
        <source>Loads what the second annotator has of the open plant as the reference, to decide place by place</source>
        <translation>Charge comme référence ce que le second annotateur a de la plante ouverte, pour décider endroit par endroit</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Choose the folder of the worklist</source>
        <translation>Choisir le dossier de la liste de travail</translation>
    </message>
    <message>
        <source>Choose the table of the worklist</source>
        <translation>Choisir le tableau de la liste de travail</translation>
    </message>
    <message>
        <source>Tables (*.csv *.tsv *.txt)</source>
        <translation>Tableaux (*.csv *.tsv *.txt)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>this row has no file to open: it says what is wrong</source>
        <translation>cette ligne n’a pas de fichier à ouvrir&#xa0;: elle dit ce qui ne va pas</translation>
    </message>
    <message>
        <source>%1 is open</source>
        <translation>%1 est ouvert</translation>
    </message>
    <message>
        <source>there is no worklist yet: choose a folder or a table for it</source>
        <translation>il n’y a pas encore de liste de travail&#xa0;: choisissez pour elle un dossier ou un tableau</translation>
    </message>
    <message>
        <source>The worklist is being read</source>
        <translation>La liste de travail est en cours de lecture</translation>
    </message>
    <message>
        <source>no other plant that the worklist shows is still to be signed</source>
        <translation>aucune autre plante que montre la liste de travail n’est encore à signer</translation>
    </message>
    <message>
        <source>the worklist has no project of a second annotator for the plant that is open</source>
        <translation>la liste de travail n’a pas de projet d’un second annotateur pour la plante ouverte</translation>
    </message>
    <message>
        <source>the plants that are still to be signed are open in other windows</source>
        <translation>les plantes encore à signer sont ouvertes dans d’autres fenêtres</translation>
    </message>
</context>
<context>
    <name>espalier::WorklistModel</name>
    <message>
        <source>Plant</source>
        <translation>Plante</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Constats</translation>
    </message>
    <message>
        <source>Minutes at work by hand; pauses of over 5 minutes do not count</source>
        <translation>Minutes de travail à la main&#xa0;; les pauses de plus de 5 minutes ne comptent pas</translation>
    </message>
    <message>
        <source>Minutes</source>
        <translation>Minutes</translation>
    </message>
    <message>
        <source>Annotator</source>
        <translation>Annotateur</translation>
    </message>
    <message>
        <source>Who else works on the same scan, or whose structure the seal names</source>
        <translation>Qui d’autre travaille sur le même scan, ou celui dont le sceau nomme la structure</translation>
    </message>
    <message>
        <source>Second annotator</source>
        <translation>Second annotateur</translation>
    </message>
    <message>
        <source>Agreement</source>
        <translation>Accord</translation>
    </message>
    <message>
        <source>under 1</source>
        <translation>moins de 1</translation>
    </message>
    <message>
        <source>F of both structures; the tip of a row says within which distance</source>
        <translation>F des deux structures&#xa0;; l’infobulle d’une ligne dit à quelle distance près</translation>
    </message>
    <message>
        <source>Findings of the checks, without doubts, that were open when the plant was signed, or last checked</source>
        <translation>Constats des contrôles, sans les doutes, qui étaient ouverts quand la plante a été signée ou contrôlée pour la dernière fois</translation>
    </message>
</context>
<context>
    <name>espalier::WorklistPanel</name>
    <message>
        <source>%1 to do</source>
        <translation>%1 à faire</translation>
    </message>
    <message>
        <source>%1 automatic</source>
        <translation>%1 automatique(s)</translation>
    </message>
    <message>
        <source>%1 in review</source>
        <translation>%1 en révision</translation>
    </message>
    <message>
        <source>%1 signed</source>
        <translation>%1 signée(s)</translation>
    </message>
    <message>
        <source>%1 with a problem</source>
        <translation>%1 avec un problème</translation>
    </message>
    <message>
        <source>%1 being read</source>
        <translation>%1 en cours de lecture</translation>
    </message>
    <message>
        <source>1 plant</source>
        <translation>1 plante</translation>
    </message>
    <message>
        <source>%1 plants</source>
        <translation>%1 plantes</translation>
    </message>
    <message>
        <source>Next ▸</source>
        <translation>Suivant ▸</translation>
    </message>
    <message>
        <source>State of the plants that are shown</source>
        <translation>État des plantes affichées</translation>
    </message>
    <message>
        <source>All states</source>
        <translation>Tous les états</translation>
    </message>
    <message>
        <source>Not signed</source>
        <translation>Non signée</translation>
    </message>
    <message>
        <source>To do</source>
        <translation>À faire</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>In review</source>
        <translation>En révision</translation>
    </message>
    <message>
        <source>Signed</source>
        <translation>Signée</translation>
    </message>
    <message>
        <source>With a problem</source>
        <translation>Avec un problème</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Dossier…</translation>
    </message>
    <message>
        <source>Table…</source>
        <translation>Tableau…</translation>
    </message>
    <message>
        <source>Worklist</source>
        <translation>Liste de travail</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Choose a folder of scans and projects, or a table that names them: they are listed here, and opened one after another.</source>
        <translation>Choisissez un dossier de scans et de projets, ou un tableau qui les nomme&#xa0;: ils sont listés ici, et ouverts l’un après l’autre.</translation>
    </message>
    <message>
        <source>No plant of the worklist is in this state.</source>
        <translation>Aucune plante de la liste de travail n’est dans cet état.</translation>
    </message>
    <message>
        <source>The worklist is being read.</source>
        <translation>La liste de travail est en cours de lecture.</translation>
    </message>
</context>
<context>
    <name>jobs</name>
    <message>
        <source>about %1 s left</source>
        <translation>encore environ %1 s</translation>
    </message>
    <message>
        <source>about %1 min left</source>
        <translation>encore environ %1 min</translation>
    </message>
</context>
</TS>
