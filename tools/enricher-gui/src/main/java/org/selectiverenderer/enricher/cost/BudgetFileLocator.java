package org.selectiverenderer.enricher.cost;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.enricher.settings.EnricherSettings;
import org.selectiverenderer.validation.ValidationSettings;
import org.selectiverenderer.validation.run.RuleCatalogue;
import org.selectiverenderer.validation.settings.BudgetSettingsEditor;

/**
 * Locates the validator's settings file that applies to a scene: the one that the author has chosen
 * for the scene's folder, else the nearest of the default name in the folder or its parents, else
 * one of that name beside the scene, which is created with its first limit. Thread-safe.
 */
public final class BudgetFileLocator {
  /** The default file name. */
  public static final String NAME = ".selective-renderer-validate.json";

  private static final String KEY = "validate-settings ";

  private final Supplier<Path> scene;
  private final EnricherSettings settings;
  private final Limit limit;
  private volatile @Nullable Path chosen;

  /** Takes from settings what the author has not agreed to. */
  @FunctionalInterface
  public interface Limit {
    ValidationSettings limited(ValidationSettings read, ProblemCollector problems);
  }

  /**
   * @param scene the document's file
   * @param limit what a settings file that comes with the scene may open
   */
  public BudgetFileLocator(Supplier<Path> scene, EnricherSettings settings, Limit limit) {
    this.scene = scene;
    this.limit = limit;
    this.settings = settings;
    String before = settings.word(KEY + folder(), "");
    chosen = before.isEmpty() ? null : Path.of(before);
  }

  private Path folder() {
    Path path = scene.get().toAbsolutePath().normalize();
    return path.getParent() == null ? path : path.getParent();
  }

  /** The file, which need not exist. */
  public Path file() {
    Path wanted = chosen;
    if (wanted != null) {
      return wanted;
    }
    Path folder = folder();
    for (Path up = folder; up != null; up = up.getParent()) {
      if (Files.isRegularFile(up.resolve(NAME))) {
        return up.resolve(NAME);
      }
    }
    return folder.resolve(NAME);
  }

  /** Uses another file for the scenes of this folder, also after a restart. */
  void choose(Path file) {
    chosen = file.toAbsolutePath().normalize();
    settings.put(KEY + folder(), chosen);
  }

  /** The scene's file as its budgets name it. */
  String sceneName() {
    return budgets().named(scene.get());
  }

  BudgetSettingsEditor budgets() {
    return new BudgetSettingsEditor(file(), RuleCatalogue.standard());
  }

  /**
   * Reads the present settings, with the folders and hosts that the author has agreed to.
   *
   * @return empty when the file has faults, which are then in {@code problems}
   * @throws IOException if it cannot be read at all
   */
  public Optional<ValidationSettings> settings(ProblemCollector problems) throws IOException {
    return budgets().read(problems).map(read -> limit.limited(read, problems));
  }
}
