package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.base.files.SettingsFolder;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.trust.PermissionRequests;
import org.selectiverenderer.base.trust.TrustStore;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.study.definition.StudyPermissions;
import org.selectiverenderer.study.definition.StudyReader;
import org.selectiverenderer.study.definition.StudyTemplate;
import org.selectiverenderer.study.threshold.ThresholdStudy;
import org.selectiverenderer.study.threshold.ThresholdStudyReader;

/** Remembers that the user agrees to what a study asks for that a command has just written. */
final class NewStudyTrust {
  private NewStudyTrust() {}

  /**
   * Remembers the permissions of the study, and of its pilot and threshold pilot if it has them:
   * the scene that the user has named, and the tracker of the template.
   */
  static void remember(Path study, Console console) throws IOException {
    TrustStore store = new TrustStore(SettingsFolder.ofUser());
    ProblemCollector problems = new ProblemCollector();
    List<PermissionRequests> asked = new ArrayList<>();
    Path pilot = study.resolveSibling("pilot");
    StudyReader.read(study, problems).map(StudyPermissions::of).ifPresent(asked::add);
    if (Files.isRegularFile(pilot.resolve(StudyTemplate.STUDY))) {
      StudyReader.read(pilot.resolve(StudyTemplate.STUDY), problems)
          .map(StudyPermissions::of)
          .ifPresent(asked::add);
      ThresholdStudyReader.read(pilot.resolve("threshold.json"), problems)
          .map(ThresholdStudy::permissions)
          .ifPresent(asked::add);
    }
    try {
      for (PermissionRequests each : asked) {
        if (!each.isEmpty()) {
          store.remember(each);
        }
      }
    } catch (IOException e) {
      console.message("sessions will ask about the study's scene: " + e.getMessage());
    }
  }
}
