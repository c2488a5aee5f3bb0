package org.selectiverenderer.validation;

import java.io.IOException;
import java.io.InputStream;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.selectiverenderer.x3d.NodeCatalogue;
import org.selectiverenderer.x3d.Problems;
import org.selectiverenderer.x3d.SceneDocument;
import org.selectiverenderer.x3d.X3dFile;
import org.selectiverenderer.x3d.X3dReader;

/** Parses a file and runs the checks that need no other file. Safe for use by several threads. */
final class FileChecker {
  private final NodeCatalogue catalogue = NodeCatalogue.load();
  private final X3dReader reader = new X3dReader(catalogue);
  private final Outliner outliner = new Outliner();
  private final List<FileCheck> checks;
  private final Set<String> ids;

  FileChecker(RuleCatalogue rules) {
    checks = rules.groups().stream().flatMap(group -> group.fileChecks().stream()).toList();
    ids = rules.rules().stream().map(Rule::id).collect(Collectors.toSet());
  }

  /**
   * Checks a file.
   *
   * @throws IOException if it cannot be read
   */
  FileResult check(SourceFile file) throws IOException {
    long size = file.size();
    SceneDocument document;
    try (InputStream in = file.open()) {
      document = reader.document(file.name(), in, size);
    }
    // What the reader says of the scene is for who shows it; here the checks speak.
    X3dFile scene = reader.scene(document, new Problems());
    Findings findings = new Findings();
    FileView view = new FileView(catalogue, document, scene, ids);
    checks.forEach(check -> check.check(view, findings));
    return new FileResult(
        outliner.outline(file, size, document, scene), findings.list(), Suppressions.of(document));
  }
}
