package org.selectiverenderer.browser.loading;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.browser.scene.SceneImports;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;

/**
 * Makes the imports and exports of a running scene from the IMPORT and EXPORT statements of its
 * file.
 *
 * @param nodes returns the running node for a parsed one; empty if it was left out
 */
record ImportBuilder(Scene scene, Function<ParsedNode, Optional<Node>> nodes) {
  void build(X3dFile file) {
    for (X3dFile.Import wanted : file.imports()) {
      scene
          .imports()
          .add(
              new SceneImports.Declared(
                  wanted.inlineDef(), wanted.importedDef(), wanted.as(), wanted.location()));
    }
    for (X3dFile.ImportedRoute route : file.importedRoutes()) {
      Optional<SceneImports.End> from = end(route.from());
      Optional<SceneImports.End> to = end(route.to());
      SourceLocation location = route.location();
      if (from.isPresent() && to.isPresent()) {
        scene.imports().add(new SceneImports.Link(from.get(), to.get(), location));
      }
    }
    file.exportedInstances()
        .forEach(
            (name, fields) ->
                scene.exportInstance(
                    name,
                    new SceneImports.ExportedInstance(
                        own(fields.inputs()), own(fields.outputs()))));
  }

  private Map<String, List<SceneImports.End.Own>> own(Map<String, List<X3dFile.End.Own>> parsed) {
    Map<String, List<SceneImports.End.Own>> own = new LinkedHashMap<>();
    parsed.forEach(
        (name, ends) -> {
          List<SceneImports.End.Own> made = new ArrayList<>();
          for (X3dFile.End.Own each : ends) {
            nodes
                .apply(each.node())
                .ifPresent(node -> made.add(new SceneImports.End.Own(node, each.field())));
          }
          own.put(name, List.copyOf(made));
        });
    return own;
  }

  private Optional<SceneImports.End> end(X3dFile.End end) {
    if (end instanceof X3dFile.End.Imported imported) {
      return Optional.of(new SceneImports.End.Imported(imported.name(), imported.field()));
    }
    X3dFile.End.Own own = (X3dFile.End.Own) end;
    return nodes.apply(own.node()).map(node -> new SceneImports.End.Own(node, own.field()));
  }
}
