package org.selectiverenderer.enricher;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.authoring.file.XmlConversion;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.base.files.AtomicFileWriter;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.enricher.task.TaskExecutor;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

/**
 * Offers to convert a scene in another encoding to X3D XML, as only XML is edited. For the event
 * dispatch thread.
 */
final class ConversionPrompt {
  /** The number of conversion problems that one dialog lists; the rest is counted. */
  private static final int TOLD = 5;

  private final NodeCatalogue catalogue;
  private final TaskExecutor tasks;
  private final UserPrompts questions;
  private final Consumer<Path> opening;
  private final Consumer<String> say;

  /**
   * @param opening opens a scene that is XML
   * @param say shows a message in the status bar
   */
  ConversionPrompt(
      NodeCatalogue catalogue,
      TaskExecutor tasks,
      UserPrompts questions,
      Consumer<Path> opening,
      Consumer<String> say) {
    this.catalogue = catalogue;
    this.tasks = tasks;
    this.questions = questions;
    this.opening = opening;
    this.say = say;
  }

  /**
   * Opens a scene, after converting it if it is not XML and the author agrees.
   *
   * @param asItIs opens an XML scene unconverted, and tells the author if that fails
   * @param nothing called when nothing is opened
   */
  void open(Path path, Runnable asItIs, Runnable nothing) {
    tasks.run(
        Texts.of("window.opening", String.valueOf(path.getFileName())),
        () -> XmlConversion.of(path),
        foreign -> foreign.ifPresentOrElse(scene -> offer(path, scene, nothing), asItIs),
        failed -> tell(nothing, failed));
  }

  private void tell(Runnable nothing, Exception failed) {
    nothing.run();
    questions.tell(String.valueOf(failed.getMessage()));
  }

  private void offer(Path path, XmlConversion scene, Runnable nothing) {
    Path target = scene.beside();
    boolean wanted =
        questions.convert(
            Texts.of(
                "window.convert",
                String.valueOf(path.getFileName()),
                scene.encoding(),
                String.valueOf(target.getFileName())));
    if (!wanted
        || Files.exists(target)
            && !questions.overwrite(
                Texts.of("keep.exists", String.valueOf(target.getFileName())))) {
      nothing.run();
      say.accept(Texts.of("window.notopened", String.valueOf(path.getFileName())));
      return;
    }
    ProblemCollector problems = new ProblemCollector();
    tasks.run(
        Texts.of("window.converting", String.valueOf(path.getFileName())),
        () -> write(scene, target, problems),
        written -> {
          tell(problems);
          written.ifPresentOrElse(opening, nothing);
        },
        failed -> tell(nothing, failed));
  }

  private Optional<Path> write(XmlConversion scene, Path target, ProblemCollector problems)
      throws IOException {
    Optional<String> xml = scene.xml(catalogue, problems);
    if (xml.isPresent()) {
      AtomicFileWriter.replace(target, xml.get().getBytes(StandardCharsets.UTF_8));
    }
    return xml.map(text -> target);
  }

  private void tell(ProblemCollector problems) {
    if (problems.list().isEmpty()) {
      return;
    }
    StringBuilder sentence = new StringBuilder();
    for (Problem problem : problems.list().subList(0, Math.min(TOLD, problems.list().size()))) {
      sentence.append(problem).append(". ");
    }
    int more = problems.list().size() - TOLD;
    questions.tell(
        sentence
            + (more > 0
                ? Texts.of("window.morefaults", more, DecimalFormatter.grouped(more))
                : ""));
  }
}
