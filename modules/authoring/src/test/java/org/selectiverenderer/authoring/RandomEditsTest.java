package org.selectiverenderer.authoring;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;

/** Whatever is edited: the tree is that of the text, and undoing all gives the bytes back. */
class RandomEditsTest {
  private static final int EDITS = 400;
  private static final String[] PIECES = {
    "",
    " ",
    "\n",
    "\r\n",
    "x",
    "<",
    ">",
    "/",
    "'",
    "<Group/>",
    "<Group DEF='G'>",
    "</Group>",
    "<!-- c -->",
    "<!--",
    "-->",
    "<Shape USE='G'/>",
    " DEF='H'",
    "<![CDATA[ <a> ]]>",
    "&amp;",
    "<Switch><Box/><Box/></Switch>",
    "\u03b1",
    "\ud83d\ude00"
  };

  @Test
  void anEditOfManyPlacesIsOneStepAndTheTreeIsThatOfTheText() throws IOException {
    int places = 5000;
    String text =
        "<X3D version='4.0'><Scene>" + "<Group DEF='A'/>\n".repeat(places) + "</Scene></X3D>";
    SceneDocument document = SceneDocument.of("a.x3d", text.getBytes(StandardCharsets.UTF_8));
    List<DocumentListener.Change> heard = new ArrayList<>();
    document.addListener(heard::add);
    List<TextEdit> changes = new ArrayList<>();
    for (int at = text.indexOf('A'); at >= 0; at = text.indexOf('A', at + 1)) {
      changes.add(new TextEdit(at, at + 1, "B" + changes.size()));
    }
    document.perform(new Edit("Name all", changes));
    assertSameAsReadAnew(document);
    assertThat(document.tree().orElseThrow().named("B" + (places - 1))).isPresent();
    // Found again one by one, each element would be read for itself.
    assertThat(heard).singleElement().matches(DocumentListener.Change::readAnew);
    document.history().undo();
    assertThat(document.text()).hasToString(text);
    assertSameAsReadAnew(document);
  }

  @Test
  void aTreeIsMendedWithTheSameElementsWhenHalfATagIsTakenAway() throws IOException {
    String text =
        "<X3D><Scene>" + "<Group DEF='A'><Shape/></Group>\n".repeat(2000) + "</Scene></X3D>";
    SceneDocument document = SceneDocument.of("a.x3d", text.getBytes(StandardCharsets.UTF_8));
    DocumentElement last = document.tree().orElseThrow().scene().orElseThrow().children().get(1999);
    int at = text.indexOf("<Shape/>", text.length() / 2);
    document.type(at, at, "<Gr");
    document.type(at + 3, at + 3, "oup ");
    assertSameAsReadAnew(document);
    assertThat(document.fault()).isPresent();
    assertThat(last.attached()).isFalse();

    document.type(at, at + 7, "");

    assertSameAsReadAnew(document);
    assertThat(last.attached()).isTrue();
    assertThat(document.tree().orElseThrow().at(last.start() + 1)).containsSame(last);
  }

  /** A fault far behind the change that makes it. */
  @ParameterizedTest
  @ValueSource(strings = {"<!--", "<Group>", "</Group>", "<![CDATA[", "<Group a='"})
  void aFaultIsFoundHoweverFarBehindTheChange(String piece) throws IOException {
    String text =
        "<X3D>\r\n<Scene>" + "<Group DEF='A'><Shape/></Group>\n".repeat(9000) + "</Scene></X3D>";
    SceneDocument document = SceneDocument.of("a.x3d", text.getBytes(StandardCharsets.UTF_8));
    int at = text.indexOf("<Group", 1000);

    document.type(at, at, piece);

    String broken = document.text().toString();
    SceneDocument fresh = SceneDocument.of("a.x3d", broken.getBytes(StandardCharsets.UTF_8));
    assertThat(document.fault()).isPresent().isEqualTo(fresh.fault());
    assertThat(document.tree()).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8})
  void theTreeFollowsAndUndoingGivesTheBytesBack(int seed) throws IOException {
    Random random = new Random(seed);
    byte[] bytes = scene().getBytes(StandardCharsets.UTF_8);
    SceneDocument document = SceneDocument.of("a.x3d", bytes);
    List<String> texts = new ArrayList<>(List.of(document.text().toString()));
    int wellFormed = 0;
    for (int i = 0; i < EDITS; i++) {
      Edit edit = edit(document, random);
      if (edit.isEmpty()) {
        continue;
      }
      document.perform(edit);
      texts.add(document.text().toString());
      assertSameAsReadAnew(document);
      wellFormed += document.tree().isPresent() ? 1 : 0;
      // A text that is broken stays so for long; most edits are to be of one that is not.
      while (document.tree().isEmpty() && random.nextInt(8) > 0) {
        document.history().undo();
        texts.remove(texts.size() - 1);
        assertSameAsReadAnew(document);
      }
    }
    assertThat(wellFormed).isGreaterThan(EDITS / 10);
    for (int i = texts.size() - 2; i >= 0; i--) {
      assertThat(document.history().undo()).isTrue();
      assertThat(document.text().toString()).isEqualTo(texts.get(i));
    }
    assertSameAsReadAnew(document);
    assertThat(document.snapshot().bytes()).isEqualTo(bytes);
    assertThat(document.modified()).isFalse();
    for (int i = 1; i < texts.size(); i++) {
      assertThat(document.history().redo()).isTrue();
      assertSameAsReadAnew(document);
    }
    assertThat(document.text().toString()).isEqualTo(texts.get(texts.size() - 1));
  }

  private static String scene() {
    StringBuilder scene = new StringBuilder("<?xml version='1.0'?>\n<X3D><Scene>\n");
    for (int i = 0; i < 6; i++) {
      scene.append(
          "  <Transform DEF='T" + i + "'>\r\n    <Switch DEF='S" + i + "' whichChoice='1'>\n");
      scene.append("      <Inline url='\"a\"'/><!-- b --><Inline url='\"b\"'/>\n    </Switch>\n");
      scene.append("    <Group/></Transform >\n");
    }
    return scene.append("</Scene></X3D>\n<!-- end -->").toString();
  }

  /** Some changes: of whole elements or of any characters, one or many. */
  private static Edit edit(SceneDocument document, Random random) {
    List<TextEdit> changes = new ArrayList<>();
    int at = 0;
    int count = random.nextInt(4) == 0 ? 1 + random.nextInt(12) : 1;
    for (int i = 0; i < count; i++) {
      TextEdit change = change(document, random);
      if (change.from() >= at) {
        changes.add(change);
        at = change.to();
      }
    }
    return new Edit("Change", changes);
  }

  private static TextEdit change(SceneDocument document, Random random) {
    CharSequence text = document.text();
    int from = random.nextInt(text.length() + 1);
    String piece = PIECES[random.nextInt(PIECES.length)];
    boolean split = from > 0 && from < text.length() && Character.isLowSurrogate(text.charAt(from));
    if (split) {
      from--;
    }
    if (document.tree().isPresent() && random.nextInt(3) > 0) {
      DocumentElement element = document.tree().get().at(from).orElse(document.tree().get().root());
      return switch (random.nextInt(4)) {
        case 0 -> TextEdit.insert(element.start(), "<Group DEF='N'/>");
        case 1 -> TextEdit.insert(element.end(), piece);
        case 2 -> TextEdit.insert(element.tagEnd(), "<Box/>");
        default ->
            element.parent().isPresent() && random.nextInt(3) == 0
                ? TextEdit.remove(element.start(), element.end())
                : new TextEdit(
                    element.start(), element.end(), "<Cone>" + document.text(element) + "</Cone>");
      };
    }
    int to = Math.min(text.length(), from + random.nextInt(4));
    if (to > 0 && to < text.length() && Character.isLowSurrogate(text.charAt(to))) {
      to++;
    }
    return new TextEdit(from, to, piece);
  }

  private static void assertSameAsReadAnew(SceneDocument document) throws IOException {
    String text = document.text().toString();
    SceneDocument fresh = SceneDocument.of("a.x3d", text.getBytes(StandardCharsets.UTF_8));
    assertThat(document.fault()).as(text).isEqualTo(fresh.fault());
    assertThat(described(document)).as(text).isEqualTo(described(fresh));
    for (int offset = 0; offset <= text.length(); offset += 7) {
      SourceLocation location = document.location(offset);
      assertThat(location).isEqualTo(fresh.location(offset));
    }
  }

  private static List<String> described(SceneDocument document) {
    List<String> lines = new ArrayList<>();
    document
        .tree()
        .ifPresent(
            tree ->
                tree.root()
                    .visit(
                        element ->
                            lines.add(
                                element
                                    + " "
                                    + element.use().orElse("")
                                    + element.start()
                                    + "-"
                                    + element.tagEnd()
                                    + "-"
                                    + element.end()
                                    + element.parent().map(DocumentElement::toString).orElse("")
                                    + element.attached()
                                    + element.def().map(tree::used).orElse(false))));
    return lines;
  }
}
