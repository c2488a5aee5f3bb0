package org.selectiverenderer.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.validation.Report;
import org.selectiverenderer.validation.RuleCatalogue;
import org.selectiverenderer.validation.SceneFinder;
import org.selectiverenderer.validation.SourceFile;
import org.selectiverenderer.validation.ValidationSettings;
import org.selectiverenderer.validation.Validator;
import org.selectiverenderer.validation.report.TextReport;
import org.selectiverenderer.x3d.Problem.Severity;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

@Command(
    name = "validate",
    description =
        "Checks scenes and all that they inline: X3D, geometry, files and the enrichment.",
    footer = "  ./selective-renderer validate scenes/")
final class ValidateCommand extends CliCommand {
  @Parameters(paramLabel = "PATH", description = "scenes, or folders of scenes")
  private List<Path> paths = List.of();

  ValidateCommand(Console console) {
    super(console);
  }

  @Override
  ExitStatus run() throws IOException {
    Path base = Path.of("");
    List<SourceFile> files = new ArrayList<>();
    for (Path path : paths) {
      files.addAll(new SceneFinder(base).find(path));
    }
    Report report =
        new Validator(RuleCatalogue.standard(), ValidationSettings.standard(), base)
            .validate(files);
    console().out().print(TextReport.of(report));
    console().out().flush();
    return report.has(Severity.ERROR) ? ExitStatus.PROBLEMS : ExitStatus.DONE;
  }
}
