package org.selectiverenderer.authoring;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;
import org.selectiverenderer.x3d.source.TextEdit;

/** Undo holds what edits have replaced, not the text, and reads no more than they touch. */
class UndoMemoryTest {
  private static final int OBJECTS = 20_000;

  private static SceneDocument large() throws IOException {
    StringBuilder scene = new StringBuilder("<X3D version='4.0'>\n<Scene>\n");
    for (int i = 0; i < OBJECTS; i++) {
      scene.append("<Transform DEF='T" + i + "' translation='0 0 0'><Shape/></Transform>\n");
    }
    byte[] bytes = (scene + "</Scene></X3D>").getBytes(StandardCharsets.UTF_8);
    return SceneDocument.of("large.x3d", bytes);
  }

  @Test
  void twoHundredStepsOfALargeSceneHoldWhatTheyReplaced() throws IOException {
    SceneDocument document = large();
    String before = document.text().toString();
    ElementTree tree = document.tree().orElseThrow();
    DocumentElement last = tree.named("T" + (OBJECTS - 1)).orElseThrow();
    int[] readAnew = {0};
    document.addListener(change -> readAnew[0] += change.readAnew() ? 1 : 0);
    for (int i = 0; i < 200; i++) {
      DocumentElement object = tree.named("T" + i * 7).orElseThrow();
      TextEdit change = document.layout().attribute(object, "translation", "1 2 " + i);
      document.perform(new Edit("Move", List.of(change)));
    }
    assertThat(document.history().names()).hasSize(200);
    assertThat(document.history().characters()).isLessThan(200 * 100);
    while (document.history().undo()) {
      // all of them
    }
    assertThat(document.text()).hasToString(before);
    assertThat(document.history().characters()).isLessThan(200 * 100);
    assertThat(readAnew[0]).as("times that the whole text was read again").isZero();
    assertThat(document.tree()).containsSame(tree);
    assertThat(last.attached()).isTrue();
  }

  /** Returns a history of a text whose changes are one at a time. */
  private static UndoHistory history(StringBuilder text, long most) {
    return new UndoHistory(
        changes -> {
          TextEdit change = changes.get(0);
          String was = text.substring(change.from(), change.to());
          text.replace(change.from(), change.to(), change.text());
          return List.of(new TextEdit(change.from(), change.from() + change.text().length(), was));
        },
        most);
  }

  @Test
  void whatIsUndoneCountsToo() {
    StringBuilder text = new StringBuilder();
    UndoHistory history = history(text, 2500);
    for (int i = 0; i < 6; i++) {
      history.perform(new Edit("Step " + i, List.of(TextEdit.insert(0, "x".repeat(1000)))));
    }
    history.markSaved();
    assertThat(history.names()).hasSize(6);
    while (history.undo()) {
      assertThat(history.characters()).isLessThanOrEqualTo(2500);
    }
    assertThat(text).as("all steps back").isEmpty();
    int again = 0;
    while (history.redo()) {
      again++;
    }
    assertThat(again).as("steps that can be repeated").isEqualTo(2);
    assertThat(text).hasSize(2000);
    assertThat(history.modified()).as("what was saved cannot be reached").isTrue();
  }

  @Test
  void mergedTypingForgetsToo() {
    StringBuilder text = new StringBuilder("-".repeat(400));
    UndoHistory history = history(text, 500);
    history.perform(new Edit("Delete", List.of(TextEdit.remove(0, 300))));
    for (int i = 0; i < 20; i++) {
      history.type("Typing", TextEdit.insert(i, "x"));
    }
    assertThat(history.names()).containsExactly("Typing");
  }

  @Test
  void manySmallChangesCountWithWhatEachTakes() {
    UndoHistory history = new UndoHistory(changes -> changes, 10_000);
    for (int i = 0; i < 3; i++) {
      List<TextEdit> digits =
          IntStream.range(0, 100).mapToObj(at -> new TextEdit(at, at + 1, "7")).toList();
      history.perform(new Edit("Weld " + i, digits));
    }
    assertThat(history.names()).containsExactly("Weld 2");
  }

  @Test
  void theOldestStepsBeyondTheMemoryAreForgotten() {
    StringBuilder text = new StringBuilder("-".repeat(40));
    UndoHistory history = history(text, 250);
    history.markSaved();
    for (int i = 0; i < 5; i++) {
      String now = String.valueOf(i).repeat(40);
      history.perform(new Edit("Step " + i, List.of(new TextEdit(0, 40, now))));
    }
    assertThat(history.names()).containsExactly("Step 3", "Step 4");
    assertThat(history.characters()).isEqualTo(2 * (40 + 64));
    while (history.undo()) {
      // as far as it goes
    }
    assertThat(text).hasToString("2".repeat(40));
    assertThat(history.modified()).as("what was saved cannot be reached").isTrue();
    history.perform(new Edit("Long", List.of(new TextEdit(0, 40, "x".repeat(400)))));
    history.perform(new Edit("Short", List.of(new TextEdit(0, 400, ""))));
    assertThat(history.names()).as("the last step stays, however long").containsExactly("Short");
  }
}
