package org.selectiverenderer.enricher;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.file.CrashRecovery;
import org.selectiverenderer.authoring.file.DocumentFile;
import org.selectiverenderer.authoring.file.ThreeWayMerge;
import org.selectiverenderer.enricher.UserPrompts.Left;
import org.selectiverenderer.enricher.session.EnricherSession;

class CrashRecoveryPromptTest {
  @TempDir Path folder;
  private final Answers answers = new Answers();
  private final List<Path> restored = new ArrayList<>();

  /** An author who answers one question after the other. */
  private static final class Answers implements UserPrompts {
    private final Queue<Left> answers = new ArrayDeque<>();
    private final List<String> asked = new ArrayList<>();

    @Override
    public Left left(String sentence) {
      asked.add(sentence);
      return answers.remove();
    }

    @Override
    public Unsaved unsaved(String name) {
      throw new AssertionError(name);
    }

    @Override
    public boolean convert(String sentence) {
      throw new AssertionError(sentence);
    }

    @Override
    public boolean revert(String sentence) {
      throw new AssertionError(sentence);
    }

    @Override
    public boolean overwrite(String sentence) {
      throw new AssertionError(sentence);
    }

    @Override
    public OnDisk changedOnDisk(String sentence, List<OnDisk> among) {
      throw new AssertionError(sentence);
    }

    @Override
    public Optional<List<ThreeWayMerge.Choice>> merge(ThreeWayMerge merge) {
      throw new AssertionError("nothing is merged");
    }

    @Override
    public LeftBehind leaveBehind(String sentence) {
      throw new AssertionError(sentence);
    }

    @Override
    public boolean without(String sentence, List<String> lines) {
      throw new AssertionError(sentence);
    }

    @Override
    public boolean replace(String sentence, List<String> lines) {
      throw new AssertionError(sentence);
    }

    @Override
    public Optional<Path> modelToImport(Path scene) {
      return Optional.empty();
    }

    @Override
    public boolean saveFaulty(String sentence) {
      throw new AssertionError(sentence);
    }

    @Override
    public boolean trust(String sentence, List<String> lines) {
      return false;
    }

    @Override
    public Optional<Path> fileToOpen(Optional<Path> near) {
      throw new AssertionError(near);
    }

    @Override
    public Optional<Path> fileToSave(Path near) {
      throw new AssertionError(near);
    }

    @Override
    public boolean review(EnricherSession session) {
      throw new AssertionError(session);
    }

    @Override
    public void tell(String sentence) {
      throw new AssertionError(sentence);
    }
  }

  @BeforeEach
  void crash() throws IOException {
    for (String name : List.of("kitchen.x3d", "office.x3d")) {
      Path scene = Files.writeString(folder.resolve(name), "<X3D><Scene/></X3D>");
      DocumentFile file = DocumentFile.open(scene);
      file.document().type(0, 0, "<!-- mine -->");
      new CrashRecovery(folder.resolve("recovery")).keep(scene, file.document().snapshot());
    }
  }

  private CrashRecovery recovery() {
    return new CrashRecovery(folder.resolve("recovery"));
  }

  private Optional<Left> offer(Left... given) {
    answers.answers.addAll(List.of(given));
    return new CrashRecoveryPrompt(recovery(), answers, sentence -> {})
        .offer(kept -> restored.add(kept.file()));
  }

  @Test
  void theFileIsNamedAndWhatRestoringDoesIsSaid() {
    offer(Left.LATER);
    assertThat(answers.asked.get(0))
        .containsAnyOf("kitchen.x3d", "office.x3d")
        .contains(
            "Restoring opens the file with these changes; the file itself does not "
                + "change until you save.");
  }

  @Test
  void decidingLaterKeepsAll() throws IOException {
    assertThat(offer(Left.LATER)).contains(Left.LATER);
    assertThat(answers.asked).hasSize(1);
    assertThat(recovery().found()).hasSize(2);
  }

  @Test
  void onlyWhatIsDiscardedIsGone() throws IOException {
    assertThat(offer(Left.DISCARD, Left.LATER)).contains(Left.LATER);
    assertThat(recovery().found()).hasSize(1);
    assertThat(offer(Left.DISCARD)).contains(Left.DISCARD);
    assertThat(recovery().found()).isEmpty();
    assertThat(offer()).isEmpty();
  }

  @Test
  void whatIsRestoredIsOpenedAndTheOtherIsAskedAboutNextTime() throws IOException {
    assertThat(offer(Left.RESTORE)).contains(Left.RESTORE);
    assertThat(restored).hasSize(1);
    assertThat(recovery().found()).as("until it is open").hasSize(2);
  }

  @Test
  void aFileWrittenSinceIsSaid() throws IOException {
    recovery().found().stream()
        .map(CrashRecovery.RecoveryCopy::file)
        .forEach(file -> assertThat(file.toFile().setLastModified(4_000_000_000_000L)).isTrue());
    offer(Left.LATER);
    assertThat(answers.asked.get(0)).contains("one undo after restoring shows its newer text");
  }
}
