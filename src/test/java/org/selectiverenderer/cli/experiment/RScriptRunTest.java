package org.selectiverenderer.cli.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.statistics.data.Measurement;
import org.selectiverenderer.statistics.report.DesignReport.Cells;
import org.selectiverenderer.statistics.script.DesignScript;

/** R is tried with programs of the same behaviour in its place, so that no R is needed. */
@DisabledOnOs(OS.WINDOWS)
class RScriptRunTest {
  private static final DesignScript SCRIPT =
      new DesignScript(
          List.of(
              new DesignScript.Model(
                  "A",
                  List.of("quality", "f1"),
                  List.of(),
                  false,
                  false,
                  false,
                  List.of(new Measurement("001", List.of("a", "b"), 1)))));

  @TempDir private Path folder;
  private final ProblemCollector problems = new ProblemCollector();

  private String program(String commands) throws IOException {
    Path file = folder.resolve("Rscript");
    Files.writeString(file, "#!/bin/sh\n" + commands);
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwx------"));
    return file.toString();
  }

  private String fault(String program, Duration limit) throws IOException {
    assertThat(new RScriptRun(program, limit).tables(SCRIPT, problems)).isEmpty();
    assertThat(problems.list()).hasSize(1);
    String fault = problems.list().get(0).toString();
    assertThat(fault).doesNotContain("\n").contains("the report has no results of R");
    return fault;
  }

  @Test
  void resultsHaveTheNamesOfTheFactors() throws IOException {
    String program =
        program(
            """
            test -f data.csv || exit 1
            printf 'analysis,model,effect,df1,df2,statistic,value,p,ges\\n' > "$4"
            printf '1,anova,f1:f2,1,23,F,4.56789,0.0434,0.01234\\n' >> "$4"
            printf '1,"(1 + f1 | participant)",f1,1,,chi2,2,0.1573,\\n' >> "$4"
            """);
    Cells table =
        new RScriptRun(program, Duration.ofSeconds(60))
            .tables(SCRIPT, problems)
            .orElseThrow()
            .get(0);
    assertThat(problems.list()).isEmpty();
    assertThat(table.rows())
        .containsExactly(
            List.of("quality x f1", "anova", "F", "4.568", "1", "23", "0.0434", "0.012"),
            List.of(
                "quality", "(1 + quality | participant)", "chi2", "2.000", "1", "", "0.1573", ""));
  }

  @Test
  void withoutRItIsOneLine() throws IOException {
    assertThat(fault(folder.resolve("none").toString(), Duration.ofSeconds(60)))
        .contains("there is no Rscript to run; install R");
  }

  @Test
  void aMissingPackageIsOneLine() throws IOException {
    assertThat(
            fault(
                program("echo 'R lacks the package afex; install it' >&2\nexit 3\n"),
                Duration.ofSeconds(60)))
        .contains("R failed: R lacks the package afex; install it");
  }

  @Test
  void anErrorOfRIsItsLine() throws IOException {
    assertThat(
            fault(
                program("echo 'Error: no fit'; echo 'Execution halted'; exit 1\n"),
                Duration.ofSeconds(60)))
        .contains("R failed: Error: no fit");
  }

  @Test
  void aProgramThatNeverEndsIsEnded() throws IOException {
    assertThat(fault(program("sleep 600\n"), Duration.ofSeconds(1)))
        .contains("R took longer than 1 s");
  }

  @Test
  void aProgramThatWritesNothingIsTold() throws IOException {
    assertThat(fault(program("exit 0\n"), Duration.ofSeconds(60)))
        .contains("R has written no results");
  }
}
