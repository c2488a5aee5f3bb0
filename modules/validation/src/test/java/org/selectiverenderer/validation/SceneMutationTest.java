package org.selectiverenderer.validation;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.validation.report.ReportFormat;
import org.selectiverenderer.validation.run.RuleCatalogue;
import org.selectiverenderer.validation.run.Validator;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.X3dReader;

/**
 * Good scenes, corrupted at random: whatever comes of it, the validator ends in bounded time with a
 * report and without an exception; and where the reader finds an error, so does the validator.
 */
class SceneMutationTest {
  private static final int CASES = 10_000;
  private static final int PER_RUN = 100;
  private static final long SEED = 20261121;
  private static final Path BASE = Path.of("");

  @Test
  void corruptedScenesAreAnsweredWithAReport() throws IOException {
    SceneMutator mutants = new SceneMutator(SEED);
    for (int done = 0; done < CASES; done += PER_RUN) {
      List<SourceFile> files = new ArrayList<>();
      for (int i = 0; i < PER_RUN; i++) {
        String name = "case-" + (done + i) + ".x3d";
        files.add(SourceFile.of(BASE.resolve("scenes").resolve(name), name, mutants.next()));
      }
      Assertions.assertTimeoutPreemptively(Duration.ofSeconds(60), () -> check(files));
    }
  }

  private static void check(List<SourceFile> files) throws IOException {
    ValidationReport report =
        new Validator(RuleCatalogue.standard(), ValidationSettings.standard(), BASE)
            .validate(files);
    for (ReportFormat format : ReportFormat.values()) {
      // Well-formed reports are ReportFormatTest's; here they must come about at all.
      assertThat(format.write(report, new ReportFormat.Style(false, Severity.ERROR, "1")))
          .as(format.name())
          .endsWith("\n");
    }
    String junit =
        ReportFormat.JUNIT.write(report, new ReportFormat.Style(false, Severity.ERROR, "1"));
    new X3dReader(NodeCatalogue.load())
        .document("junit.xml", new ByteArrayInputStream(junit.getBytes(UTF_8)), junit.length())
        .faults()
        .forEach(fault -> assertThat(fault.message()).as(junit).isEmpty());
    for (ReportFormat format : List.of(ReportFormat.JSON, ReportFormat.SARIF)) {
      String json = format.write(report, new ReportFormat.Style(false, Severity.ERROR, "1"));
      assertThat(JsonMapper.builder().build().readTree(json).isObject()).isTrue();
    }
    Set<String> found =
        report.findings().stream()
            .map(finding -> finding.location().file())
            .collect(Collectors.toSet());
    X3dReader reader = new X3dReader(NodeCatalogue.load());
    for (SourceFile file : files) {
      ProblemCollector problems = new ProblemCollector();
      byte[] content = file.open().readAllBytes();
      reader.read(file.name(), new ByteArrayInputStream(content), problems);
      boolean wrong =
          problems.list().stream().anyMatch(problem -> problem.severity() == Severity.ERROR);
      String scene = new String(content, UTF_8);
      if (wrong && !scene.contains("validate-ignore")) {
        assertThat(found).as("%s\n%s", problems.list(), scene).contains(file.name());
      }
    }
  }
}
