package org.selectiverenderer.testing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.extension.ConditionEvaluationResult;
import org.junit.jupiter.api.extension.ExecutionCondition;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.ExtensionContext.Namespace;

/** Decides for {@link RequiresSymbolicLinks}; tries to make a link once per test run. */
final class SymbolicLinkCondition implements ExecutionCondition {
  private static final Namespace NAMESPACE = Namespace.create(SymbolicLinkCondition.class);

  @Override
  public ConditionEvaluationResult evaluateExecutionCondition(ExtensionContext context) {
    return context
        .getRoot()
        .getStore(NAMESPACE)
        .computeIfAbsent(Lack.class, key -> new Lack(attempt()), Lack.class)
        .reason()
        .map(ConditionEvaluationResult::disabled)
        .orElseGet(() -> ConditionEvaluationResult.enabled("this user can make symbolic links"));
  }

  private static Optional<String> attempt() {
    if (!OS.WINDOWS.isCurrentOs()) {
      return Optional.empty(); // There every user can; a test that cannot fails.
    }
    try {
      Path folder = Files.createTempDirectory("selective-renderer-link");
      Path link = folder.resolve("link");
      try {
        Files.createSymbolicLink(link, Path.of("target"));
        return Files.isSymbolicLink(link)
            ? Optional.empty()
            : Optional.of("this system makes a file instead of a symbolic link");
      } finally {
        Files.deleteIfExists(link);
        Files.delete(folder);
      }
    } catch (UnsupportedOperationException | IOException e) {
      return Optional.of("no symbolic links can be made here: " + e);
    }
  }

  /** What is missing, if anything; the store cannot hold an Optional by its type. */
  private record Lack(Optional<String> reason) {}
}
