package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.trust.PermissionRequest.Kind;
import org.selectiverenderer.base.trust.PermissionRequests;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.trust.TrustOption;
import org.selectiverenderer.command.trust.TrustPrompt;
import org.selectiverenderer.study.definition.StudyPermissions;
import org.selectiverenderer.study.definition.StudyTemplate;
import org.selectiverenderer.study.session.LoadedStudy;
import picocli.CommandLine.Parameters;

/** The parameter that names the study of a command. */
final class StudyArgument {
  @Parameters(
      paramLabel = "STUDY.json",
      description = "study file, or the folder that contains study.json")
  private Path study = Path.of("");

  StudyArgument() {}

  /** Creates the argument of a command that names its study by an option. */
  StudyArgument(Path study) {
    this.study = study;
  }

  /**
   * Reads the study for a command that shows no scene and opens no device; it needs the user's
   * agreement to files outside of the study's folder only, and such pictures as are in folders that
   * the study asks for.
   *
   * @return empty when it has errors, which are reported to {@code problems}
   */
  Optional<LoadedStudy> read(TrustOption trust, Console console, ProblemCollector problems)
      throws IOException {
    return read(Optional.empty(), trust, console, problems);
  }

  /**
   * Reads the study in one of its languages, as {@link #read(TrustOption, Console,
   * ProblemCollector)}.
   */
  Optional<LoadedStudy> read(
      Optional<String> language, TrustOption trust, Console console, ProblemCollector problems)
      throws IOException {
    return LoadedStudy.read(
        file(),
        language,
        read -> {
          PermissionRequests all = StudyPermissions.of(read);
          trust.require(
              file(), all.of(Kind.FILE, Kind.FOLDER), TrustPrompt.onTerminal(console), console);
          return false;
        },
        problems);
  }

  /**
   * Reads the study in each of its languages for a command that copies its scenes, which needs the
   * user's agreement to files outside of its folder.
   */
  Optional<List<LoadedStudy>> readToCopy(
      TrustOption trust, Console console, ProblemCollector problems) throws IOException {
    return LoadedStudy.readAll(
        file(),
        Optional.empty(),
        read -> {
          PermissionRequests all = StudyPermissions.of(read);
          trust.require(
              file(), all.of(Kind.FILE, Kind.FOLDER), TrustPrompt.onTerminal(console), console);
          return true;
        },
        problems);
  }

  /**
   * Reads the study for a session, which needs the user's agreement to all that the study asks for.
   *
   * @param language the language that comes first; empty for the study's first
   * @return the study in each of its languages; empty when it has errors, which are reported to
   *     {@code problems}
   */
  Optional<List<LoadedStudy>> readForSession(
      Optional<String> language,
      TrustOption trust,
      TrustPrompt prompt,
      Console console,
      ProblemCollector problems)
      throws IOException {
    return LoadedStudy.readAll(
        file(),
        language,
        read -> {
          PermissionRequests all = StudyPermissions.of(read);
          trust.require(file(), all, prompt, console);
          return true;
        },
        problems);
  }

  private Path file() {
    return Files.isDirectory(study) ? study.resolve(StudyTemplate.STUDY) : study;
  }
}
