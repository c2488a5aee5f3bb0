package org.selectiverenderer.enricher;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.Optional;
import org.selectiverenderer.base.files.AtomicFileWriter;
import org.selectiverenderer.base.files.HomeFolder;
import org.selectiverenderer.enricher.access.AccessDialog;
import org.selectiverenderer.enricher.importing.PackageDialog;
import org.selectiverenderer.enricher.newscene.NewSceneDialog;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.settings.AllowedPlaces;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/**
 * The commands of the File menu that create scenes, open them in other windows, and decide what
 * they may read. For the event dispatch thread.
 */
final class FileCommands {
  private final EnricherWindow window;
  private final UserPrompts questions;

  FileCommands(EnricherWindow window, UserPrompts questions) {
    this.window = window;
    this.questions = questions;
  }

  /** Asks for the kind and the file of a new scene, writes it and opens it. */
  void newScene() {
    new NewSceneDialog(
            window.frame(),
            proposed(),
            (over, sentence) -> new DialogUserPrompts(over).overwrite(sentence))
        .ask()
        .ifPresent(this::create);
  }

  /** Writes a scene and opens it. A file that has appeared since the answer is asked about. */
  void create(NewSceneDialog.Answer scene) {
    if (window.windows().showOther(scene.file(), window)) {
      window.say(Texts.of("window.taken", String.valueOf(scene.file().getFileName())));
      return;
    }
    window
        .saves()
        .leaving(
            () -> {
              try {
                if (written(scene)) {
                  window.openUnasked(scene.file());
                }
              } catch (IOException e) {
                questions.tell(String.valueOf(e.getMessage()));
              }
            });
  }

  /** Returns whether the file was written; else the author wants to keep the one that is there. */
  private boolean written(NewSceneDialog.Answer scene) throws IOException {
    if (!scene.replace()) {
      try {
        AtomicFileWriter.writeOnce(scene.file(), scene.text());
        return true;
      } catch (IOException e) {
        if (!Files.exists(scene.file(), LinkOption.NOFOLLOW_LINKS)) {
          throw e;
        }
      }
      if (!questions.overwrite(Texts.of("keep.exists", scene.file().toString()))) {
        return false;
      }
    }
    AtomicFileWriter.replace(scene.file(), scene.text().getBytes(StandardCharsets.UTF_8));
    return true;
  }

  /** Returns an unused file beside the open scene, else in the user's home folder. */
  private Path proposed() {
    Path folder =
        window
            .session()
            .map(open -> open.file().path().toAbsolutePath().getParent())
            .filter(Files::isDirectory)
            .orElseGet(HomeFolder::ofUser);
    String name = Texts.of("create.name");
    Path file = folder.resolve(name + ".x3d");
    for (int i = 2; Files.exists(file) && i < 1000; i++) {
      file = folder.resolve(name + i + ".x3d");
    }
    return file;
  }

  /** Asks for a scene and opens it in a window of its own. */
  void openInNewWindow() {
    questions
        .fileToOpen(window.session().map(open -> open.file().path()))
        .ifPresent(window.windows()::openNew);
  }

  /** Asks where the open scene is packaged, and packages it with all that it names. */
  void packageScene() {
    window
        .bench()
        .ifPresent(
            bench -> {
              bench.commit();
              new PackageDialog(window.frame(), bench.session().file().path())
                  .ask()
                  .ifPresent(
                      target -> new PackageCommands(questions).write(bench.session(), target));
            });
  }

  /** Returns what a scene may read: what the author allows it, and what every scene may read. */
  ContentAccessPolicy access(Path scene) {
    return AllowedPlaces.of(window.look().settings(), scene).and(window.look().access());
  }

  /** Asks for the folders and hosts that the open scene may read from, and reads it again. */
  void allow() {
    Optional<Workbench> bench = window.bench();
    if (bench.isEmpty()) {
      window.say(Texts.of("access.none"));
      return;
    }
    EnricherSession session = bench.get().session();
    Path scene = session.file().path();
    AllowedPlaces before = AllowedPlaces.of(window.look().settings(), scene);
    new AccessDialog(window.frame(), scene, before)
        .ask()
        .filter(now -> !now.equals(before))
        .ifPresent(
            now -> {
              now.keep(window.look().settings(), scene);
              session.allow(access(scene));
              bench.get().accessChanged();
              window.say(stored(scene));
            });
  }

  private String stored(Path scene) {
    try {
      window.look().settings().store();
      return Texts.of("access.kept", String.valueOf(scene.getFileName()));
    } catch (IOException e) {
      return Texts.of("access.notkept", String.valueOf(e.getMessage()));
    }
  }
}
