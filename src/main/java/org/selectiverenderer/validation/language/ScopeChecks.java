package org.selectiverenderer.validation.language;

import java.util.List;
import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileView;
import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Runs the checks that need the name scopes of a file. */
final class ScopeChecks implements FileCheck {
  @Override
  public void check(FileView file, Findings findings) {
    Scopes scopes = new Scopes(file);
    List<ScopeCheck> checks =
        List.of(
            new ContainmentCheck(),
            new NameCheck(),
            new RouteCheck(),
            new PrototypeCheck(),
            new ConnectCheck());
    for (DocumentElement element : file.document().elements()) {
      checks.forEach(check -> check.check(element, scopes, findings));
    }
  }
}
