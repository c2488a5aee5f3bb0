package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.definition.StudyTemplate;
import org.selectiverenderer.study.session.LoadedStudy;
import picocli.CommandLine.Parameters;

/** The parameter that names the study of a command. */
final class StudyArgument {
  @Parameters(
      paramLabel = "STUDY.json",
      description = "study file, or the folder that contains study.json")
  private Path study = Path.of("");

  /** Reads the study; empty when it has errors, which are reported to {@code problems}. */
  Optional<LoadedStudy> read(ProblemCollector problems) throws IOException {
    return LoadedStudy.read(
        Files.isDirectory(study) ? study.resolve(StudyTemplate.STUDY) : study, problems);
  }
}
