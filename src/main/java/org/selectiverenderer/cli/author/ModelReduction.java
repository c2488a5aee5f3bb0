package org.selectiverenderer.cli.author;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.files.FileTransaction;
import org.selectiverenderer.base.markup.ControlCharacterEscaper;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.command.output.CommandFileCheck;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.output.UndeletedFilesWarning;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.models.Model;
import org.selectiverenderer.models.ModelReader;
import org.selectiverenderer.models.ModelWriter;
import org.selectiverenderer.models.simplify.EmptyModelException;
import org.selectiverenderer.models.simplify.ModelSize;
import org.selectiverenderer.models.simplify.SimplificationResult;
import org.selectiverenderer.models.simplify.SimplificationTarget;
import org.selectiverenderer.models.simplify.Simplifier;
import org.selectiverenderer.x3d.source.Gzip;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/**
 * Reduces one model and prints its polygon counts.
 *
 * @param reader reads the model
 * @param access the files and URLs that the model may load besides those in its folder
 * @param output the file to write; null for standard output
 * @param json whether the report is JSON, in which case standard output gets only the report
 * @param many whether it is one of many models, so that the report names it
 */
record ModelReduction(
    SimplificationTarget goal,
    ModelReader reader,
    ContentAccessPolicy access,
    @Nullable Path output,
    boolean json,
    boolean many) {

  ExitStatus run(Path file, Console console) throws IOException {
    ProblemCollector problems = new ProblemCollector(console::problem);
    Optional<Model> read = reader.read(file, problems);
    if (read.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    new CommandFileCheck().writes("--output", output).check(access.named());
    Model model = read.get();
    ModelSize size = ModelSize.of(model.meshes());
    if (ReductionGoalOptions.beyond(goal, size, file, problems)) {
      return ExitStatus.PROBLEMS;
    }
    long start = System.nanoTime();
    SimplificationResult reduced;
    try {
      reduced = new Simplifier().simplify(model.meshes(), goal);
    } catch (EmptyModelException e) {
      problems.error(SourceLocation.of(file.toString()), "the model " + e.getMessage());
      return ExitStatus.PROBLEMS;
    }
    long milliseconds = (System.nanoTime() - start) / 1_000_000;
    write(file, model.with(reduced.parts()), reduced, console);
    print(file, size, reduced, milliseconds, console);
    if (!reduced.met()) {
      console.message(ReductionGoalOptions.shortfall(file.toString(), goal, reduced));
    }
    return reduced.met() ? ExitStatus.of(problems) : ExitStatus.PROBLEMS;
  }

  private void write(Path file, Model model, SimplificationResult reduced, Console console)
      throws IOException {
    Path target = output == null ? Path.of("model.x3d") : output;
    if (output == null && json) {
      return;
    }
    Path folder = target.toAbsolutePath().getParent();
    String text =
        new ModelWriter()
            .text(
                model,
                folder == null ? target.toAbsolutePath() : folder,
                String.valueOf(target.getFileName()),
                "%s, reduced to %s"
                    .formatted(
                        file.getFileName(), ReductionGoalOptions.polygonText(reduced.polygons())));
    if (output == null) {
      console.out().print(text);
      return;
    }
    FileTransaction writing = new FileTransaction();
    byte[] plain = text.getBytes(StandardCharsets.UTF_8);
    boolean packed = output.toString().toLowerCase(Locale.ROOT).endsWith(".x3dz");
    writing.add(output, packed ? Gzip.packed(plain) : plain);
    UndeletedFilesWarning.tell(writing.commit(), console);
  }

  private void print(
      Path file, ModelSize size, SimplificationResult reduced, long milliseconds, Console console) {
    if (json) {
      ObjectNode report = JsonTree.object();
      if (many) {
        report.put("model", file.toString());
      }
      report.putObject("input").put("vertices", size.vertices()).put("polygons", size.polygons());
      report
          .putObject("output")
          .put("vertices", reduced.vertices())
          .put("polygons", reduced.polygons());
      report.put("error", reduced.error()).put("ms", milliseconds);
      console.line(report.toString());
      return;
    }
    PrintStream to = output == null ? console.err() : console.out();
    if (many) {
      to.println(ControlCharacterEscaper.line(file.toString()));
    }
    String text =
        String.format(
            Locale.ROOT,
            "Max Vertex     %9d   polygons %9d%n"
                + "Vert Count     %9d   polygons %9d%n"
                + "Vert Percent   %8.1f%%            %8.1f%%%n"
                + "largest error  %8.3f%%  of the model's largest extent%n"
                + "took           %9d ms%n",
            size.vertices(),
            size.polygons(),
            reduced.vertices(),
            reduced.polygons(),
            100.0 * reduced.vertices() / size.vertices(),
            100.0 * reduced.polygons() / size.polygons(),
            100 * reduced.error(),
            milliseconds);
    to.print(text);
  }
}
