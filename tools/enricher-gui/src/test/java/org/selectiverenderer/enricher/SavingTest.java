package org.selectiverenderer.enricher;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.enricher.driving.Sessions;
import org.selectiverenderer.enricher.session.EnricherSession;

class SavingTest {
  @TempDir Path folder;
  private EnricherSession session;
  private Answers answers;
  private Saving saving;

  /** An author of fixed answers. */
  private static final class Answers implements Questions {
    private final List<String> asked = new ArrayList<>();
    private Unsaved unsaved = Unsaved.CANCEL;
    private boolean agree = true;

    @Override
    public Unsaved unsaved(String name) {
      asked.add("unsaved");
      return unsaved;
    }

    @Override
    public boolean overwrite(String sentence) {
      asked.add("overwrite");
      return agree;
    }

    @Override
    public boolean reload(String sentence) {
      asked.add("reload");
      return agree;
    }

    @Override
    public Optional<Path> fileToOpen(Optional<Path> near) {
      return Optional.empty();
    }

    @Override
    public Optional<Path> fileToSave(Path near) {
      return Optional.of(near.resolveSibling("other.x3d"));
    }

    @Override
    public boolean review(EnricherSession session) {
      asked.add("review");
      return agree;
    }

    @Override
    public void tell(String sentence) {
      asked.add(sentence);
    }
  }

  @BeforeEach
  void open() throws IOException {
    session = Sessions.with(folder, Sessions.object("Cup"));
    answers = new Answers();
    saving = new Saving(session, answers);
  }

  private void type() {
    session.document().type(0, 0, "<!-- mine -->");
  }

  private String onDisk() throws IOException {
    return Files.readString(session.file().path());
  }

  @Test
  void nothingIsAskedWhereNothingHasChanged() {
    assertThat(saving.save(true)).isTrue();
    assertThat(saving.mayClose(true)).isTrue();
    assertThat(answers.asked).isEmpty();
  }

  @Test
  void changesAreReviewedThenSaved() throws IOException {
    type();
    assertThat(saving.save(true)).isTrue();
    assertThat(answers.asked).containsExactly("review");
    assertThat(onDisk()).startsWith("<!-- mine -->");
  }

  @Test
  void aReviewThatIsNotConfirmedLeavesTheFileAsItWas() throws IOException {
    answers.agree = false;
    type();
    assertThat(saving.save(true)).isFalse();
    assertThat(onDisk()).doesNotContain("mine");
    assertThat(session.document().modified()).isTrue();
  }

  @Test
  void closingWithUnsavedWorkAsks() throws IOException {
    type();
    assertThat(saving.mayClose(false)).isFalse();
    answers.unsaved = Questions.Unsaved.SAVE;
    assertThat(saving.mayClose(false)).isTrue();
    assertThat(onDisk()).contains("mine");
  }

  @Test
  void whatAnotherProgramWroteIsOverwrittenOnlyWhenTheAuthorAgrees() throws IOException {
    type();
    Files.writeString(session.file().path(), "<X3D><!-- theirs --></X3D>");
    answers.agree = false;
    assertThat(saving.save(false)).isFalse();
    assertThat(onDisk()).contains("theirs");
    answers.agree = true;
    assertThat(saving.save(false)).isTrue();
    assertThat(onDisk()).contains("mine");
  }

  @Test
  void aChangeOnTheDiskIsAskedAboutOnce() throws IOException {
    assertThat(saving.wantsReload()).isFalse();
    Files.writeString(session.file().path(), "<X3D><!-- theirs --></X3D>");
    assertThat(saving.wantsReload()).isTrue();
    assertThat(saving.wantsReload()).isFalse();
    assertThat(answers.asked).containsExactly("reload");
  }

  @Test
  void savingUnderAnotherNameLeavesTheFirstFile() throws IOException {
    Path first = session.file().path();
    type();
    assertThat(saving.saveAs()).isTrue();
    assertThat(Files.readString(first)).doesNotContain("mine");
    assertThat(session.file().path()).hasFileName("other.x3d");
  }
}
