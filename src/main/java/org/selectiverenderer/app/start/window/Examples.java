package org.selectiverenderer.app.start.window;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.selectiverenderer.app.examples.ExampleFiles;
import org.selectiverenderer.app.examples.ExampleFolder;
import org.selectiverenderer.app.recent.RecentPaths;
import org.selectiverenderer.app.start.Example;
import org.selectiverenderer.swing.BackgroundReader;

/**
 * The examples in the folder that the user has chosen for them. They are copied there once; what is
 * missing comes back when it is opened, and what the user has changed stays. For Swing's event
 * thread; files are read and written on the reader's.
 */
final class Examples {
  /** Asks for the folder of the examples. */
  @FunctionalInterface
  interface FolderPrompt {
    /**
     * @param files number of the examples
     * @param bytes their size
     * @return empty if the user does not want them
     */
    Optional<Path> ask(int files, long bytes);
  }

  private final BackgroundReader reader;
  private final RecentPaths folders;
  private final FolderPrompt prompt;
  private final Consumer<String> say;
  private final Runnable copied;

  /**
   * @param folders the folders that were chosen
   * @param say shows a sentence to the user; empty takes away the one before
   * @param copied called when the examples have been copied
   */
  Examples(
      BackgroundReader reader,
      RecentPaths folders,
      FolderPrompt prompt,
      Consumer<String> say,
      Runnable copied) {
    this.reader = reader;
    this.folders = folders;
    this.prompt = prompt;
    this.say = say;
    this.copied = copied;
  }

  /** Returns the folder of the examples, which is read from the disk; empty if there is none. */
  Optional<Path> folder() {
    return folders.list().stream().limit(1).filter(Files::isDirectory).findFirst();
  }

  private record Found(Optional<Path> folder, Map<String, byte[]> examples) {}

  /**
   * Has an example copied where it is not yet, and opens it.
   *
   * @param open receives its file
   */
  void open(Example example, Consumer<Path> open) {
    reader.read(
        () -> {
          Optional<Path> folder = folder();
          boolean there =
              folder.filter(known -> Files.exists(known.resolve(example.scene()))).isPresent();
          return new Found(folder, there ? Map.of() : ExampleFiles.read());
        },
        found -> {
          if (found.folder().isPresent() && found.examples().isEmpty()) {
            open.accept(found.folder().get().resolve(example.scene()));
            return;
          }
          Map<String, byte[]> examples = found.examples();
          long bytes = examples.values().stream().mapToLong(content -> content.length).sum();
          found
              .folder()
              .or(() -> prompt.ask(examples.size(), bytes))
              .ifPresent(folder -> copy(folder, examples, example, open));
        },
        say);
  }

  private void copy(
      Path folder, Map<String, byte[]> examples, Example example, Consumer<Path> open) {
    say.accept(StartTexts.of("copy.running", folder.toString()));
    reader.read(
        () -> {
          ExampleFolder copies = new ExampleFolder(folder);
          ExampleFolder.Copies done = copies.complete(examples);
          folders.add(folder);
          Path scene = copies.file(example.scene());
          if (!Files.exists(scene)) {
            throw new IOException(StartTexts.of("copy.missing", example.scene()));
          }
          return new Copied(scene, done);
        },
        done -> {
          copied.run();
          open.accept(done.scene());
          if (!done.copies().changed().isEmpty()) {
            say.accept(
                StartTexts.of(
                    "copy.changed",
                    done.copies().changed().stream()
                        .map(Path::toString)
                        .collect(Collectors.joining(", "))));
          }
        },
        say);
  }

  private record Copied(Path scene, ExampleFolder.Copies copies) {}
}
