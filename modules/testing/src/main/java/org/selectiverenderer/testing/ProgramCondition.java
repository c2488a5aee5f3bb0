package org.selectiverenderer.testing;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.extension.ConditionEvaluationResult;
import org.junit.jupiter.api.extension.ExecutionCondition;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.platform.commons.support.AnnotationSupport;

/** Decides for {@link RequiresProgram}. */
final class ProgramCondition implements ExecutionCondition {
  private static final Map<String, String> REQUIRED =
      Map.of(
          "Rscript", "SELECTIVE_RENDERER_REQUIRE_R",
          "bids-validator-deno", "SELECTIVE_RENDERER_REQUIRE_BIDS",
          "python3", "SELECTIVE_RENDERER_REQUIRE_PYTHON");

  @Override
  public ConditionEvaluationResult evaluateExecutionCondition(ExtensionContext context) {
    Optional<RequiresProgram> wanted =
        AnnotationSupport.findAnnotation(context.getElement(), RequiresProgram.class);
    if (wanted.isEmpty()) {
      return ConditionEvaluationResult.enabled("needs no program");
    }
    String program = wanted.get().value();
    String variable = REQUIRED.get(program);
    if (variable == null) {
      throw new IllegalArgumentException("no environment variable requires " + program);
    }
    boolean found = onPath(program, Optional.ofNullable(System.getenv("PATH")).orElse(""));
    return decide(program, found, variable, "1".equals(System.getenv(variable)));
  }

  /**
   * Runs, skips or fails.
   *
   * @throws IllegalStateException if the program is missing and tests with it are required
   */
  static ConditionEvaluationResult decide(
      String program, boolean found, String variable, boolean required) {
    if (found) {
      return ConditionEvaluationResult.enabled(program + " is installed");
    }
    if (required) {
      throw new IllegalStateException(
          variable + "=1, but tests with " + program + " cannot run: it is not on the path");
    }
    return ConditionEvaluationResult.disabled(program + " is not on the path");
  }

  /** Whether a folder of the path has that program, by the endings of any system. */
  static boolean onPath(String program, String path) {
    return Arrays.stream(path.split(File.pathSeparator))
        .flatMap(ProgramCondition::folder)
        .flatMap(
            folder ->
                Stream.of("", ".exe", ".cmd", ".bat").map(end -> folder.resolve(program + end)))
        .anyMatch(file -> Files.isRegularFile(file) && Files.isExecutable(file));
  }

  private static Stream<Path> folder(String name) {
    try {
      return name.isEmpty() ? Stream.empty() : Stream.of(Path.of(name));
    } catch (InvalidPathException e) {
      return Stream.empty(); // such as a quoted folder on Windows, where nothing can be found
    }
  }
}
