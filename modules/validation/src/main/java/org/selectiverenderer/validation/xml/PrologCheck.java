package org.selectiverenderer.validation.xml;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileContext;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.XmlDocument;

/** Checks the file's name, its DOCTYPE and its root element. */
final class PrologCheck implements FileCheck {
  private static final Pattern VERSION = Pattern.compile("DTD X3D (\\d\\.\\d)");

  @Override
  public void check(FileContext file, FindingCollector findings) {
    XmlDocument document = file.document();
    String name = document.name().toLowerCase(Locale.ROOT);
    if (document.isCompressed() && (name.endsWith(".x3d") || name.endsWith(".xml"))) {
      findings.add(
          XmlRules.NAME_OF_COMPRESSED,
          SourceLocation.of(document.name()),
          "",
          name.substring(name.lastIndexOf('.')));
    }
    DocumentElement root = document.root().orElse(null);
    if (root == null) {
      return;
    }
    if (!root.name().equals("X3D")) {
      findings.add(XmlRules.ROOT, root, root.name());
    }
    document.type().ifPresent(type -> checkType(type, root, findings));
  }

  private static void checkType(
      XmlDocument.DocumentType type, DocumentElement root, FindingCollector findings) {
    Matcher declared = VERSION.matcher(type.publicId());
    String version = root.text("version").map(String::strip).orElse("");
    if (declared.find() && !version.isEmpty() && !declared.group(1).equals(version)) {
      findings.add(XmlRules.DOCTYPE, type.location(), "", declared.group(1), version);
    }
  }
}
