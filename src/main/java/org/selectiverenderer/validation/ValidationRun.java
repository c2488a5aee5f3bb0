package org.selectiverenderer.validation;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import org.selectiverenderer.x3d.ContentRoot;
import org.selectiverenderer.x3d.ParsedNode;
import org.selectiverenderer.x3d.UrlChoice;

/**
 * One run of the validator: begins to check every file as soon as something names it, then checks
 * the scenes. No task waits for another.
 */
final class ValidationRun {
  /** A scene while its files come in. */
  private record Scene(
      FileOutline main,
      ContentRoot root,
      Map<ParsedNode, FileOutline> contents,
      Set<FileOutline> followed) {}

  /** A file of a scene that is being checked, and the Inline that names it. */
  private record Pending(Scene scene, ParsedNode inline, CompletableFuture<FileResult> file) {}

  private final ValidationSettings settings;
  private final Path base;
  private final Executor executor;
  private final FileChecker checker;
  private final List<SceneCheck> sceneChecks;
  private final Map<Path, CompletableFuture<FileResult>> started = new LinkedHashMap<>();
  private final Queue<Pending> pending = new ArrayDeque<>();

  ValidationRun(RuleCatalogue rules, ValidationSettings settings, Path base, Executor executor) {
    this.settings = settings;
    this.base = base;
    this.executor = executor;
    this.checker = new FileChecker(rules);
    this.sceneChecks =
        rules.groups().stream().flatMap(group -> group.sceneChecks().stream()).toList();
  }

  Report validate(List<SourceFile> files) {
    List<CompletableFuture<FileResult>> mains = files.stream().map(this::start).toList();
    List<Scene> scenes = new ArrayList<>();
    for (CompletableFuture<FileResult> main : new LinkedHashSet<>(mains)) {
      FileOutline outline = main.join().outline();
      Scene scene =
          new Scene(
              outline,
              new ContentRoot(outline.file().folder()),
              new IdentityHashMap<>(),
              Collections.newSetFromMap(new IdentityHashMap<>()));
      scenes.add(scene);
      follow(scene, outline);
    }
    for (Pending step = pending.poll(); step != null; step = pending.poll()) {
      FileOutline inlined = step.file.join().outline();
      step.scene.contents.put(step.inline, inlined);
      follow(step.scene, inlined);
    }
    return report(scenes);
  }

  /** Begins to check a file, unless another scene has asked for it already. */
  private CompletableFuture<FileResult> start(SourceFile file) {
    return started.computeIfAbsent(
        file.key(), key -> CompletableFuture.supplyAsync(() -> check(file), executor));
  }

  private FileResult check(SourceFile file) {
    try {
      return checker.check(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Begins to check what a file of a scene inlines. */
  private void follow(Scene scene, FileOutline outline) {
    if (!scene.followed.add(outline)) {
      return;
    }
    for (ParsedNode node : outline.nodes()) {
      if (node.type().name().equals("Inline")
          && UrlChoice.of(node, scene.root, outline.file().folder(), "")
              instanceof UrlChoice.File found
          && java.nio.file.Files.isReadable(found.path())) {
        pending.add(new Pending(scene, node, start(SourceFile.of(found.path(), base))));
      }
    }
  }

  private Report report(List<Scene> scenes) {
    List<CompletableFuture<List<Finding>>> checking =
        scenes.stream()
            .map(scene -> CompletableFuture.supplyAsync(() -> check(scene), executor))
            .toList();
    // A file of several scenes has its findings once.
    Set<Finding> all = new HashSet<>();
    Map<String, Suppressions> suppressions = new LinkedHashMap<>();
    List<SourceFile> files = new ArrayList<>();
    for (CompletableFuture<FileResult> file : started.values()) {
      FileResult result = file.join();
      all.addAll(result.findings());
      suppressions.put(result.outline().file().name(), result.suppressions());
      files.add(result.outline().file());
    }
    checking.forEach(scene -> all.addAll(scene.join()));
    return Report.of(files, new FindingFilter(settings, suppressions).apply(all));
  }

  private List<Finding> check(Scene scene) {
    Findings findings = new Findings();
    SceneView view = new SceneView(scene.main, scene.root, scene.contents, settings);
    sceneChecks.forEach(check -> check.check(view, findings));
    return findings.list();
  }
}
