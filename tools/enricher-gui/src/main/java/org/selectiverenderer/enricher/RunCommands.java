package org.selectiverenderer.enricher;

import java.awt.Window;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.selectiverenderer.enricher.menu.NodeCommand;
import org.selectiverenderer.enricher.run.InlineFileResolver;
import org.selectiverenderer.enricher.run.ProcessLauncher;
import org.selectiverenderer.enricher.run.RunConsole;
import org.selectiverenderer.enricher.run.RunDialog;
import org.selectiverenderer.enricher.run.RunOptions;
import org.selectiverenderer.enricher.run.SceneRunManager;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.DocumentElement;

/** The commands that run the open scene, and that open the files that it inlines and go back. */
final class RunCommands {
  private final Window owner;
  private final Supplier<Optional<Workbench>> bench;
  private final BiConsumer<Path, Runnable> open;
  private final Consumer<Path> openNew;
  private final Consumer<String> say;
  private final RunConsole messages;
  private final SceneRunManager runs;
  private final Deque<Path> way = new ArrayDeque<>();
  private RunOptions choice = RunOptions.USUAL;

  /**
   * @param bench the views of the open scene; empty for none
   * @param open opens a scene in place of the open one, and runs the second argument when it is
   *     open
   * @param openNew opens a scene in a window of its own
   * @param say shows a message in the status bar
   */
  RunCommands(
      Window owner,
      Supplier<Optional<Workbench>> bench,
      BiConsumer<Path, Runnable> open,
      Consumer<Path> openNew,
      Consumer<String> say) {
    this.owner = owner;
    this.bench = bench;
    this.open = open;
    this.openNew = openNew;
    this.say = say;
    messages = new RunConsole(owner);
    runs = new SceneRunManager(messages::add, say);
  }

  /** Runs the scene with the options of the last run. */
  void run() {
    bench
        .get()
        .ifPresent(
            scene -> {
              scene.commit();
              runs.run(scene.session(), choice, scene.here());
            });
  }

  /** Asks for the options and runs the scene. */
  void runAs() {
    if (bench.get().isPresent()) {
      RunDialog.ask(owner, choice)
          .ifPresent(
              chosen -> {
                choice = chosen;
                run();
              });
    }
  }

  void showMessages() {
    messages.show();
  }

  /** Opens the file of the selected Inline in place of the scene. */
  void openInline() {
    bench
        .get()
        .map(Workbench::session)
        .ifPresent(
            session ->
                target(session)
                    .ifPresent(
                        file -> {
                          Path from = session.file().path();
                          open.accept(file, () -> way.push(from));
                        }));
  }

  /** The command of a node's context menu that opens an inlined file. */
  NodeCommand openInlineOfNode() {
    return new NodeCommand(
        "openInline", Texts.of("run.inline"), InlineFileResolver::holds, element -> openInline());
  }

  /** Opens the file of the selected Inline in a window of its own. */
  void openInlineInWindow() {
    bench.get().map(Workbench::session).flatMap(this::target).ifPresent(openNew);
  }

  /** Opens the study window, in a process of its own. */
  void openStudies() {
    try {
      ProcessLauncher.studies();
    } catch (IOException e) {
      say.accept(Texts.of("run.failed", String.valueOf(e.getMessage())));
    }
  }

  private Optional<Path> target(EnricherSession session) {
    Optional<DocumentElement> element = session.selection();
    if (element.isEmpty()) {
      say.accept(Texts.of("run.noinline"));
      return Optional.empty();
    }
    InlineFileResolver.Answer answer = InlineFileResolver.of(session, element.get());
    if (answer.file().isEmpty()) {
      say.accept(answer.reason());
    }
    return answer.file();
  }

  /** The scene that an inlined file was opened from; empty for none. */
  Optional<Path> from() {
    return Optional.ofNullable(way.peek());
  }

  /** Opens the scene that the inlined file was opened from. */
  void back() {
    from().ifPresent(file -> open.accept(file, way::poll));
  }

  /** Ends all runs. */
  void dispose() {
    runs.close();
    messages.dispose();
  }
}
