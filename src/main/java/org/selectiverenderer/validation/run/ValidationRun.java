package org.selectiverenderer.validation.run;

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
import org.selectiverenderer.validation.FileOutline;
import org.selectiverenderer.validation.Finding;
import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.validation.Report;
import org.selectiverenderer.validation.ReportedNames;
import org.selectiverenderer.validation.RunCheck;
import org.selectiverenderer.validation.SceneCheck;
import org.selectiverenderer.validation.SceneView;
import org.selectiverenderer.validation.SourceFile;
import org.selectiverenderer.validation.ValidationSettings;
import org.selectiverenderer.x3d.files.ContentRoot;
import org.selectiverenderer.x3d.files.UrlChoice;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * One run of the validator: starts to check each file as soon as a scene refers to it, then checks
 * the scenes. No task blocks on another.
 */
final class ValidationRun {
  /** A scene while its files are being checked. */
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
  private final List<RunCheck> runChecks;
  private final Map<String, CompletableFuture<FileResult>> started = new LinkedHashMap<>();
  private final Queue<Pending> pending = new ArrayDeque<>();

  ValidationRun(RuleCatalogue rules, ValidationSettings settings, Path base, Executor executor) {
    this.settings = settings;
    this.base = base;
    this.executor = executor;
    this.checker = new FileChecker(rules, settings);
    this.sceneChecks =
        rules.groups().stream().flatMap(group -> group.sceneChecks().stream()).toList();
    this.runChecks = rules.groups().stream().flatMap(group -> group.runChecks().stream()).toList();
  }

  Report validate(List<SourceFile> files) {
    Map<SourceFile, ContentRoot> roots = new LinkedHashMap<>();
    files.forEach(file -> roots.put(file, new ContentRoot(file.folder(), settings.access())));
    List<CompletableFuture<FileResult>> mains =
        roots.entrySet().stream().map(file -> start(file.getKey(), file.getValue())).toList();
    List<Scene> scenes = new ArrayList<>();
    for (CompletableFuture<FileResult> main : new LinkedHashSet<>(mains)) {
      FileOutline outline = main.join().outline();
      Scene scene =
          new Scene(
              outline,
              roots.getOrDefault(
                  outline.file(), new ContentRoot(outline.file().folder(), settings.access())),
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

  /** Starts to check a file, unless another scene has requested it already. */
  private CompletableFuture<FileResult> start(SourceFile file, ContentRoot root) {
    return started.computeIfAbsent(
        file.key(), key -> CompletableFuture.supplyAsync(() -> check(file, root), executor));
  }

  private FileResult check(SourceFile file, ContentRoot root) {
    try {
      return checker.check(file, root);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Starts to check the files that a file of a scene inlines. */
  private void follow(Scene scene, FileOutline outline) {
    if (!scene.followed.add(outline)) {
      return;
    }
    for (ParsedNode node : outline.nodes()) {
      if (node.type().name().equals("Inline")
          && UrlChoice.of(node, scene.root, node.base(outline.file().base()), "")
              instanceof UrlChoice.Found found
          && found.content().file().map(java.nio.file.Files::isReadable).orElse(true)) {
        pending.add(
            new Pending(scene, node, start(SourceFile.of(found.content(), base), scene.root)));
      }
    }
  }

  private Report report(List<Scene> scenes) {
    // A file of several scenes contributes its findings once.
    Set<Finding> all = new HashSet<>();
    int dropped = 0;
    Map<String, Suppressions> suppressions = new LinkedHashMap<>();
    List<SourceFile> files = new ArrayList<>();
    for (CompletableFuture<FileResult> file : started.values()) {
      FileResult result = file.join();
      all.addAll(result.findings());
      dropped += result.dropped();
      suppressions.put(result.outline().file().name(), result.suppressions());
      files.add(result.outline().file());
    }
    Set<Scene> parts = parts(scenes);
    WantedFindings wanted = new WantedFindings(settings, suppressions);
    List<CompletableFuture<Findings>> checking =
        scenes.stream()
            .map(
                scene ->
                    CompletableFuture.supplyAsync(
                        () -> check(view(scene, parts), wanted), executor))
            .toList();
    for (CompletableFuture<Findings> scene : checking) {
      all.addAll(scene.join().list());
      dropped += scene.join().dropped();
    }
    Findings ofRun = new Findings(wanted);
    Path file = settings.file();
    RunCheck.Settings given =
        new RunCheck.Settings(settings, file == null ? "" : ReportedNames.relative(file, base));
    List<SceneView> views = scenes.stream().map(scene -> view(scene, parts)).toList();
    runChecks.forEach(check -> check.check(views, given, ofRun));
    all.addAll(ofRun.list());
    List<Finding> weighed =
        all.stream().map(finding -> finding.with(settings.severity(finding.rule()))).toList();
    return Report.of(files, weighed, dropped);
  }

  private Findings check(SceneView view, WantedFindings wanted) {
    Findings findings = new Findings(wanted);
    sceneChecks.forEach(check -> check.check(view, findings));
    return findings;
  }

  /** Returns the scenes that other scenes inline; of scenes that inline each other, all but one. */
  private static Set<Scene> parts(List<Scene> scenes) {
    Set<Scene> parts = Collections.newSetFromMap(new IdentityHashMap<>());
    for (Scene scene : scenes) {
      boolean part =
          scenes.stream()
              .anyMatch(
                  other ->
                      other != scene
                          && !parts.contains(other)
                          && other.followed.contains(scene.main));
      if (part) {
        parts.add(scene);
      }
    }
    return parts;
  }

  private SceneView view(Scene scene, Set<Scene> parts) {
    return new SceneView(scene.main, scene.root, scene.contents, parts.contains(scene), settings);
  }
}
