package org.selectiverenderer.enricher;

import java.nio.file.Path;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.enricher.settings.AllowedPlaces;
import org.selectiverenderer.enricher.settings.EnricherSettings;
import org.selectiverenderer.enricher.settings.RecentFiles;
import org.selectiverenderer.enricher.text.Texts;

/**
 * The save commands of the File menu, which also ask before unsaved changes are lost. For the event
 * dispatch thread.
 */
final class SaveCommands {
  private final UserPrompts questions;
  private final BooleanSupplier reviews;
  private final Consumer<String> say;
  private final Runnable refresh;
  private final EnricherSettings settings;
  private final Predicate<Path> elsewhere;

  /** The open document and what saves it. */
  private record Open(Workbench bench, DocumentSaver saving) {}

  private @Nullable Open open;

  /**
   * @param elsewhere brings another window to the front that has a file; false if none has it
   * @param reviews whether the author looks at the changes before they are saved
   * @param refresh updates title and menus of the window
   */
  SaveCommands(
      UserPrompts questions,
      Predicate<Path> elsewhere,
      BooleanSupplier reviews,
      Consumer<String> say,
      Runnable refresh,
      EnricherSettings settings) {
    this.questions = questions;
    this.reviews = reviews;
    this.say = say;
    this.refresh = refresh;
    this.elsewhere = elsewhere;
    this.settings = settings;
  }

  /** Starts with a document that has been opened. */
  void begin(Workbench bench) {
    open = new Open(bench, new DocumentSaver(bench.session(), questions, elsewhere));
  }

  /** Ends with the document, which has been closed. */
  void end() {
    open = null;
  }

  /**
   * Runs an action that closes the document, once the author has saved it or agreed to lose the
   * changes.
   */
  void leaving(Runnable leave) {
    if (open == null) {
      leave.run();
    } else {
      open.bench().commit();
      open.saving().leaving(reviews.getAsBoolean(), leave);
    }
  }

  void save() {
    save(reviews.getAsBoolean());
  }

  private void save(boolean review) {
    Open saved = open;
    if (saved != null) {
      saved.bench().commit();
      saved
          .saving()
          .save(
              review,
              () -> {
                forget(saved.bench(), saved.bench().session().file().path());
                refresh.run();
              });
    }
  }

  void saveAs() {
    Open saved = open;
    if (saved != null) {
      saved.bench().commit();
      Path before = saved.bench().session().file().path();
      saved
          .saving()
          .saveAs(
              () -> {
                forget(saved.bench(), before);
                Path now = saved.bench().session().file().path();
                AllowedPlaces.of(settings, before).keep(settings, now);
                new RecentFiles(settings).add(now);
                refresh.run();
              });
    }
  }

  private static void forget(Workbench saved, Path path) {
    if (!saved.session().document().modified()) {
      saved.autosave().forget(path);
    }
  }

  /** Shows what saving would change, and saves if the author wants it. */
  void showChanges() {
    if (open != null) {
      open.bench().commit();
    }
    if (open != null && open.bench().session().document().modified()) {
      save(true);
    } else {
      say.accept(Texts.of("window.unchanged"));
    }
  }

  /** Takes the text of the file in place of the document, as one step that can be undone. */
  void revert(Consumer<Path> reload) {
    if (open != null) {
      open.bench().commit();
      Path path = open.bench().session().file().path();
      open.saving().revert(() -> reload.accept(path));
    }
  }

  /** Merges the open document with its file, which another program may have changed. */
  void merge() {
    if (open != null) {
      open.bench().commit();
      open.saving().merge();
    }
  }

  /**
   * Checks whether another program has changed the file.
   *
   * @param reload opens the file again, if the author wants that
   */
  void lookAtDisk(Consumer<Path> reload) {
    if (open != null) {
      Path path = open.bench().session().file().path();
      open.saving().lookAtDisk(() -> reload.accept(path));
    }
  }
}
