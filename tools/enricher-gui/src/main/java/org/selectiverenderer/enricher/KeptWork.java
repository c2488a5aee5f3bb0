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
import org.selectiverenderer.document.file.Recovery;

/**
 * Offers the changes that sessions have left which ended unexpectedly, one after the other. They
 * are kept until the author decides. Without widgets.
 */
final class KeptWork {
  private static final DateTimeFormatter WHEN =
      DateTimeFormatter.ofPattern("d MMMM uuuu, HH:mm", Locale.ENGLISH);

  private final Recovery recovery;
  private final Questions questions;
  private final Consumer<String> say;

  /**
   * @param say shows a sentence
   */
  KeptWork(Recovery recovery, Questions questions, Consumer<String> say) {
    this.recovery = recovery;
    this.questions = questions;
    this.say = say;
  }

  /**
   * Asks about what is left, until the author restores one or wants to decide later.
   *
   * @param restore opens one in place of what is open
   * @return the last answer; empty if there was nothing to ask about
   */
  Optional<Questions.Left> offer(Consumer<Recovery.Kept> restore) {
    Optional<Questions.Left> last = Optional.empty();
    try {
      List<Recovery.Kept> found = recovery.found();
      for (int i = 0; i < found.size() && !last.filter(Questions.Left::settles).isPresent(); i++) {
        Questions.Left answer = questions.left(sentence(found.get(i)));
        last = Optional.of(answer);
        switch (answer) {
          case RESTORE -> restore.accept(found.get(i));
          case DISCARD -> recovery.forget(found.get(i));
          case LATER -> say.accept("File > Kept Changes asks again, as does the next start");
        }
      }
    } catch (IOException e) {
      say.accept("Cannot look for kept changes: " + e.getMessage());
    }
    return last;
  }

  private static String sentence(Recovery.Kept kept) throws IOException {
    String when = WHEN.format(kept.when().atZone(ZoneId.systemDefault()));
    return "%s has changes that were not saved when the enricher ended unexpectedly (%s). %s %s"
        .formatted(
            kept.file(),
            when,
            "Restoring opens the file with these changes; the file itself does not "
                + "change until you save.",
            disk(kept));
  }

  private static String disk(Recovery.Kept kept) throws IOException {
    Path file = kept.file();
    if (!Files.isRegularFile(file)) {
      return "The file itself no longer exists.";
    }
    Instant written = Files.getLastModifiedTime(file).toInstant();
    return written.isAfter(kept.when())
        ? "The file has been saved since then; one undo after restoring shows its newer text."
        : "One undo takes all of them back.";
  }
}
