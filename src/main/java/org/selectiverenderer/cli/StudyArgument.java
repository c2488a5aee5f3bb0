package org.selectiverenderer.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.selectiverenderer.experiment.session.StudyMaterial;
import org.selectiverenderer.experiment.study.StudyTemplate;
import org.selectiverenderer.x3d.Problems;
import picocli.CommandLine.Parameters;

/** The study that a command is about. */
final class StudyArgument {
  @Parameters(
      paramLabel = "STUDY.json",
      description = "the study file, or the folder of study.json")
  private Path study = Path.of("");

  /** Reads it; empty when it has faults, which are told then. */
  Optional<StudyMaterial> read(Problems problems) throws IOException {
    return StudyMaterial.read(
        Files.isDirectory(study) ? study.resolve(StudyTemplate.STUDY) : study, problems);
  }
}
