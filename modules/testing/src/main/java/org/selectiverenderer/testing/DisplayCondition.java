package org.selectiverenderer.testing;

import com.jogamp.opengl.GLException;
import com.jogamp.opengl.GLProfile;
import java.util.Locale;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.extension.ConditionEvaluationResult;
import org.junit.jupiter.api.extension.ExecutionCondition;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.ExtensionContext.Namespace;

/** Decides for {@link RequiresDisplay}; looks for OpenGL once per test run. */
final class DisplayCondition implements ExecutionCondition {
  private static final Namespace NAMESPACE = Namespace.create(DisplayCondition.class);

  @Override
  public ConditionEvaluationResult evaluateExecutionCondition(ExtensionContext context) {
    Lack lack =
        context
            .getRoot()
            .getStore(NAMESPACE)
            .computeIfAbsent(
                Lack.class, key -> new Lack(find(System.getenv("DISPLAY"))), Lack.class);
    return decide(lack.reason(), "1".equals(System.getenv("SELECTIVE_RENDERER_REQUIRE_GL")));
  }

  /**
   * Runs, skips or fails.
   *
   * @param lack what is missing
   * @throws IllegalStateException if something is missing and tests that draw are required
   */
  static ConditionEvaluationResult decide(Optional<String> lack, boolean required) {
    if (lack.isEmpty()) {
      return ConditionEvaluationResult.enabled("a display with OpenGL 3.3 core");
    }
    if (required) {
      throw new IllegalStateException(
          "SELECTIVE_RENDERER_REQUIRE_GL=1, but tests that draw cannot run: " + lack.get());
    }
    return ConditionEvaluationResult.disabled(lack.get());
  }

  private static Optional<String> find(@Nullable String display) {
    String system = System.getProperty("os.name").toLowerCase(Locale.ROOT);
    boolean x11 = !system.startsWith("windows") && !system.startsWith("mac");
    // The first touch of GLProfile throws without an X server, so that comes first.
    if (x11 && (display == null || display.isEmpty())) {
      return Optional.of("no display: DISPLAY is not set");
    }
    try {
      return GLProfile.isAvailable(GLProfile.GL3)
          ? Optional.empty()
          : Optional.of("no OpenGL 3.3 core on this display");
    } catch (GLException | LinkageError e) {
      return Optional.of("OpenGL cannot be used: " + e);
    }
  }

  /** What is missing, if anything; the store cannot hold an Optional by its type. */
  private record Lack(Optional<String> reason) {}
}
