package org.selectiverenderer.export;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.selectiverenderer.authoring.packaging.ScenePackage.LeftOut;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.RuleGroup;
import org.selectiverenderer.validation.SceneContext;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.write.SceneFormat;

/**
 * Declares the rules SR800 to SR899, about what an export cannot carry. They are checked on demand
 * only, as most scenes are never exported.
 */
public final class ExportRules {
  static final Rule NOT_CARRIED =
      Rule.error("SR801", "an export cannot carry this: {reason}")
          .because(
              """
              The command export writes a copy of the scene for browsers that know nothing of this \
              program, whose controller is a Script with ROUTEs. ROUTEs reach no node in a \
              prototype, so that its instances are written out, which cannot be done where a \
              ROUTE leads to one; and a copy lacks the files that the scene may not read.""")
          .bad(
              """
              <ProtoInstance DEF='Bin' name='BinWithVersions'/>
              <ROUTE fromNode='Click' fromField='isActive' toNode='Bin' toField='open'/>""")
          .good("<Switch DEF='Versions'><!-- with schema metadata --></Switch>")
          .see("docs/export.md");

  static final Rule NOTHING_TO_CONTROL =
      Rule.info(
              "SR802", "the scene has no enriched object, so that an export has nothing to control")
          .because("An export is for scenes whose Switches have schema metadata; enrich it first.")
          .bad("<Shape><Box/></Shape>")
          .good("<Switch DEF='Versions'><!-- with schema metadata --></Switch>")
          .see("docs/export.md");

  private ExportRules() {}

  /** Returns the rules and their check. */
  public static RuleGroup group() {
    return new RuleGroup(
        "Export", List.of(NOT_CARRIED, NOTHING_TO_CONTROL), List.of(), List.of(ExportRules::check));
  }

  private static void check(SceneContext scene, FindingCollector findings) {
    if (scene.part() || scene.main().file().inMemory() != null) {
      return; // An export begins with the scene around it, and with a file.
    }
    Path file = scene.main().file().path();
    ProblemCollector problems = new ProblemCollector();
    ExportSettings settings =
        new ExportSettings(Condition.SELECTIVE, 0, SceneFormat.XML, UnaryOperator.identity(), true);
    Optional<ExportedScene> exported;
    try {
      exported =
          new SceneExporter(NodeCatalogue.load(), scene.settings().access(), problems)
              .export(file, settings, "scene.x3d");
    } catch (IOException e) {
      problems.error(SourceLocation.of(file.toString()), String.valueOf(e.getMessage()));
      exported = Optional.empty();
    }
    Map<String, String> names = new HashMap<>();
    scene
        .files()
        .forEach(
            each -> names.put(scene.root().display(real(each.file().path())), each.file().name()));
    names.put(file.toString(), scene.main().file().name());
    for (Problem problem : problems.list()) {
      if (problem.severity() == Severity.ERROR) {
        boolean nothing = problem.message().equals(SceneExporter.NOTHING_TO_CONTROL);
        findings.add(
            nothing ? NOTHING_TO_CONTROL : NOT_CARRIED,
            named(problem.location(), names),
            "",
            nothing ? new Object[0] : new Object[] {problem.message()});
      }
    }
    for (LeftOut left : exported.map(each -> each.files().left()).orElse(List.of())) {
      findings.add(
          NOT_CARRIED,
          named(SourceLocation.of(left.file()), names),
          "",
          "url '%s' %s".formatted(left.url(), left.reason()));
    }
  }

  private static SourceLocation named(SourceLocation location, Map<String, String> names) {
    String name = names.getOrDefault(location.file(), location.file());
    return new SourceLocation(name, location.line(), location.column());
  }

  private static Path real(Path file) {
    try {
      return file.toRealPath();
    } catch (IOException e) {
      return file;
    }
  }
}
