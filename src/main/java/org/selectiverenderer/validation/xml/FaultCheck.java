package org.selectiverenderer.validation.xml;

import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileView;
import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.x3d.DocumentFault;

/** What the parser said. */
final class FaultCheck implements FileCheck {
  @Override
  public void check(FileView file, Findings findings) {
    for (DocumentFault fault : file.document().faults()) {
      findings.add(XmlRules.NOT_WELL_FORMED, fault.location(), "", fault.message());
    }
  }
}
