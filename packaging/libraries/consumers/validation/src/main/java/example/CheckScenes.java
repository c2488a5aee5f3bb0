package example;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.validation.Finding;
import org.selectiverenderer.validation.SourceFile;
import org.selectiverenderer.validation.ValidationReport;
import org.selectiverenderer.validation.ValidationSettings;
import org.selectiverenderer.validation.report.ReportFormat;
import org.selectiverenderer.validation.run.RuleCatalogue;
import org.selectiverenderer.validation.run.Validator;

/** Checks scenes, and prints what was found: for programs, then for people. */
public final class CheckScenes {
  private CheckScenes() {}

  public static void main(String[] scenes) throws IOException {
    Path base = Path.of("").toAbsolutePath();
    List<SourceFile> files = new ArrayList<>();
    for (String scene : scenes) {
      files.add(SourceFile.of(Path.of(scene), base));
    }
    Validator validator =
        new Validator(RuleCatalogue.standard(), ValidationSettings.standard(), base);
    ValidationReport report = validator.validate(files);
    for (Finding finding : report.findings()) {
      System.out.println(
          finding.severity() + " " + finding.rule().id() + " line " + finding.location().line());
    }
    System.out.println(report.has(Severity.ERROR) ? "not good X3D" : "good X3D");
    ReportFormat.Style style = new ReportFormat.Style(false, Severity.ERROR, "1");
    System.out.print(ReportFormat.TEXT.write(report, style));
  }
}
