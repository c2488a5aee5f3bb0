package org.selectiverenderer.validation.run;

import java.io.IOException;
import java.io.InputStream;
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
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.stream.Collectors;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.validation.CrossSceneCheck;
import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileContext;
import org.selectiverenderer.validation.FileOutline;
import org.selectiverenderer.validation.Finding;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.validation.ReportFileNames;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.SceneCheck;
import org.selectiverenderer.validation.SceneContext;
import org.selectiverenderer.validation.SourceFile;
import org.selectiverenderer.validation.ValidationReport;
import org.selectiverenderer.validation.ValidationSettings;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.PrototypeLibraryLoader;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.source.XmlDocument;
import org.selectiverenderer.x3d.url.ResolvedUrlContent;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * One run of the validator: starts to check each file as soon as a scene refers to it, then checks
 * the scenes. No task blocks on another.
 */
final class ValidationRun {
  /** A scene while its files are being checked. */
  private record Scene(
      FileOutline main,
      UrlResolver root,
      Map<ParsedNode, FileOutline> contents,
      Set<FileOutline> followed) {}

  /** A file of a scene that is being checked, and the Inline that names it. */
  private record Pending(Scene scene, ParsedNode inline, CompletableFuture<FileCheckResult> file) {}

  private final ValidationSettings settings;
  private final Path base;
  private final Executor executor;
  private final FileChecker checker;
  private final List<SceneCheck> sceneChecks;
  private final List<CrossSceneCheck> runChecks;
  private final Map<String, CompletableFuture<FileCheckResult>> started = new LinkedHashMap<>();
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

  ValidationReport validate(List<SourceFile> files) {
    Map<SourceFile, UrlResolver> roots = new LinkedHashMap<>();
    files.forEach(file -> roots.put(file, new UrlResolver(file.folder(), settings.access())));
    List<CompletableFuture<FileCheckResult>> mains =
        roots.entrySet().stream().map(file -> start(file.getKey(), file.getValue())).toList();
    List<Scene> scenes = new ArrayList<>();
    for (CompletableFuture<FileCheckResult> main : new LinkedHashSet<>(mains)) {
      FileOutline outline = result(main).outline();
      Scene scene =
          new Scene(
              outline,
              roots.getOrDefault(
                  outline.file(), new UrlResolver(outline.file().folder(), settings.access())),
              new IdentityHashMap<>(),
              Collections.newSetFromMap(new IdentityHashMap<>()));
      scenes.add(scene);
      follow(scene, outline);
    }
    for (Pending step = pending.poll(); step != null; step = pending.poll()) {
      FileOutline inlined = result(step.file).outline();
      step.scene.contents.put(step.inline, inlined);
      follow(step.scene, inlined);
    }
    return report(scenes);
  }

  /** Starts to check a file, unless another scene has requested it already. */
  private CompletableFuture<FileCheckResult> start(SourceFile file, UrlResolver root) {
    return started.computeIfAbsent(
        file.key(), key -> CompletableFuture.supplyAsync(() -> check(file, root), executor));
  }

  private FileCheckResult check(SourceFile file, UrlResolver root) {
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
          && ResolvedUrlContent.of(node, scene.root, node.base(outline.file().base()), "")
              instanceof ResolvedUrlContent.Found found
          && found.content().file().map(java.nio.file.Files::isReadable).orElse(true)) {
        pending.add(
            new Pending(scene, node, start(SourceFile.of(found.content(), base), scene.root)));
      }
    }
  }

  private ValidationReport report(List<Scene> scenes) {
    // A file of several scenes contributes its findings once.
    Set<Finding> all = new HashSet<>();
    int dropped = 0;
    Map<String, Suppressions> suppressions = new LinkedHashMap<>();
    List<SourceFile> files = new ArrayList<>();
    for (CompletableFuture<FileCheckResult> file : started.values()) {
      FileCheckResult result = result(file);
      all.addAll(result.findings());
      dropped += result.dropped();
      suppressions.put(result.outline().file().name(), result.suppressions());
      files.add(result.outline().file());
    }
    Set<Scene> parts = parts(scenes);
    FindingFilter wanted = new FindingFilter(settings, suppressions);
    List<CompletableFuture<FindingCollector>> checking =
        scenes.stream()
            .map(
                scene ->
                    CompletableFuture.supplyAsync(
                        () -> check(view(scene, parts), wanted), executor))
            .toList();
    for (CompletableFuture<FindingCollector> scene : checking) {
      FindingCollector found = result(scene);
      all.addAll(found.list());
      dropped += found.dropped();
    }
    FindingCollector ofRun = new FindingCollector(wanted);
    Path file = settings.file();
    CrossSceneCheck.Settings given =
        new CrossSceneCheck.Settings(
            settings, file == null ? "" : ReportFileNames.relative(file, base));
    List<SceneContext> views = scenes.stream().map(scene -> view(scene, parts)).toList();
    runChecks.forEach(check -> check.check(views, given, ofRun));
    all.addAll(ofRun.list());
    List<Finding> weighed =
        all.stream().map(finding -> finding.with(settings.severity(finding.rule()))).toList();
    return ValidationReport.of(files, weighed, dropped);
  }

  private FindingCollector check(SceneContext view, FindingFilter wanted) {
    FindingCollector findings = new FindingCollector(wanted);
    for (SceneCheck check : sceneChecks) {
      unlessInterrupted();
      check.check(view, findings);
    }
    return findings;
  }

  /** Waits for a result; unlike {@link CompletableFuture#join} an interrupt ends it. */
  private static <T> T result(CompletableFuture<T> future) {
    try {
      return future.get();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw interrupted();
    } catch (ExecutionException e) {
      throw new CompletionException(e.getCause());
    }
  }

  private static void unlessInterrupted() {
    if (Thread.currentThread().isInterrupted()) {
      throw interrupted();
    }
  }

  private static CancellationException interrupted() {
    return new CancellationException("the check was interrupted");
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

  private SceneContext view(Scene scene, Set<Scene> parts) {
    return new SceneContext(
        scene.main, scene.root, scene.contents, parts.contains(scene), settings);
  }

  /** Parses a file and runs the checks that need no other file. Thread-safe. */
  private static final class FileChecker {
    private final NodeCatalogue catalogue = NodeCatalogue.load();
    private final X3dReader reader = new X3dReader(catalogue);
    private final FileOutlineBuilder outliner = new FileOutlineBuilder();
    private final List<FileCheck> checks;
    private final Set<String> ids;
    private final ValidationSettings settings;

    FileChecker(RuleCatalogue rules, ValidationSettings settings) {
      this.settings = settings;
      checks = rules.groups().stream().flatMap(group -> group.fileChecks().stream()).toList();
      ids = rules.rules().stream().map(Rule::id).collect(Collectors.toSet());
    }

    /**
     * Checks a file.
     *
     * @param root decides which files it may refer to
     * @throws IOException if it cannot be read
     */
    FileCheckResult check(SourceFile file, UrlResolver root) throws IOException {
      long size = file.size();
      X3dReader withFiles = reader.with(new PrototypeLibraryLoader(reader, root), file.base());
      XmlDocument document;
      try (InputStream in = file.open()) {
        document = withFiles.document(file.name(), in, size);
      }
      // Problems that the reader reports are ignored, since the checks report them.
      X3dFile scene = withFiles.scene(document, new ProblemCollector());
      Suppressions suppressions = Suppressions.of(document, ids);
      FindingCollector findings =
          new FindingCollector(new FindingFilter(settings, Map.of(document.name(), suppressions)));
      FileContext view = new FileContext(catalogue, document, scene, ids);
      for (FileCheck check : checks) {
        unlessInterrupted();
        check.check(view, findings);
      }
      return new FileCheckResult(
          outliner.outline(file, size, document, scene),
          findings.list(),
          findings.dropped(),
          suppressions);
    }
  }
}
