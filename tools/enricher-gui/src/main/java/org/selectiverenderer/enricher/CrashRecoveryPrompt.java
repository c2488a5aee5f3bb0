package org.selectiverenderer.enricher;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.authoring.file.CrashRecovery;
import org.selectiverenderer.enricher.text.Texts;

/**
 * Offers to restore the unsaved changes of sessions that ended unexpectedly, one after the other.
 * Their recovery copies are kept until the author decides. Has no widgets.
 */
final class CrashRecoveryPrompt {
  private static final String WHEN = "d MMMM uuuu, HH:mm";

  private final CrashRecovery recovery;
  private final UserPrompts questions;
  private final Consumer<String> say;

  /**
   * @param say shows a message in the status bar
   */
  CrashRecoveryPrompt(CrashRecovery recovery, UserPrompts questions, Consumer<String> say) {
    this.recovery = recovery;
    this.questions = questions;
    this.say = say;
  }

  /**
   * Asks about each recovery copy, until the author restores one or wants to decide later.
   *
   * @param restore opens a recovery copy in place of the open document
   * @return the last answer; empty if there are no recovery copies
   */
  Optional<UserPrompts.Left> offer(Consumer<CrashRecovery.RecoveryCopy> restore) {
    Optional<UserPrompts.Left> last = Optional.empty();
    try {
      List<CrashRecovery.RecoveryCopy> found = recovery.found();
      for (int i = 0;
          i < found.size() && !last.filter(UserPrompts.Left::settles).isPresent();
          i++) {
        UserPrompts.Left answer = questions.left(sentence(found.get(i)));
        last = Optional.of(answer);
        switch (answer) {
          case RESTORE -> restore.accept(found.get(i));
          case DISCARD -> recovery.forget(found.get(i));
          case LATER -> say.accept(Texts.of("window.askagain"));
        }
      }
    } catch (IOException e) {
      say.accept(Texts.of("window.nolook", String.valueOf(e.getMessage())));
    }
    return last;
  }

  private static String sentence(CrashRecovery.RecoveryCopy kept) throws IOException {
    String when =
        DateTimeFormatter.ofPattern(WHEN, Locale.getDefault(Locale.Category.DISPLAY))
            .format(kept.when().atZone(ZoneId.systemDefault()));
    return Texts.of("window.kept", kept.file().toString(), when, disk(kept));
  }

  private static String disk(CrashRecovery.RecoveryCopy kept) throws IOException {
    Path file = kept.file();
    if (!Files.isRegularFile(file)) {
      return Texts.of("window.kept.gone");
    }
    Instant written = Files.getLastModifiedTime(file).toInstant();
    return written.isAfter(kept.when())
        ? Texts.of("window.kept.newer")
        : Texts.of("window.kept.undo");
  }
}
