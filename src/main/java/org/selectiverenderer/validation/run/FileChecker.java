package org.selectiverenderer.validation.run;

import java.io.IOException;
import java.io.InputStream;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileView;
import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.SourceFile;
import org.selectiverenderer.validation.ValidationSettings;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.files.ContentRoot;
import org.selectiverenderer.x3d.read.FileLibraries;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.source.XmlDocument;

/** Parses a file and runs the checks that need no other file. Thread-safe. */
final class FileChecker {
  private final NodeCatalogue catalogue = NodeCatalogue.load();
  private final X3dReader reader = new X3dReader(catalogue);
  private final Outliner outliner = new Outliner();
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
  FileResult check(SourceFile file, ContentRoot root) throws IOException {
    long size = file.size();
    XmlDocument document;
    try (InputStream in = file.open()) {
      document = reader.document(file.name(), in, size);
    }
    // Problems that the reader reports are ignored, since the checks report them.
    X3dFile scene =
        reader.with(new FileLibraries(reader, root), file.base()).scene(document, new Problems());
    Suppressions suppressions = Suppressions.of(document, ids);
    Findings findings =
        new Findings(new WantedFindings(settings, Map.of(document.name(), suppressions)));
    FileView view = new FileView(catalogue, document, scene, ids);
    checks.forEach(check -> check.check(view, findings));
    return new FileResult(
        outliner.outline(file, size, document, scene),
        findings.list(),
        findings.dropped(),
        suppressions);
  }
}
