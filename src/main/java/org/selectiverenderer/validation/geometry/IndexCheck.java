package org.selectiverenderer.validation.geometry;

import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileView;
import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.x3d.DocumentAttribute;
import org.selectiverenderer.x3d.DocumentElement;
import org.selectiverenderer.x3d.FieldType;

/** Indices against the points that they name. */
final class IndexCheck implements FileCheck {
  @Override
  public void check(FileView file, Findings findings) {
    for (DocumentElement element : file.document().elements()) {
      element.attribute("coordIndex").ifPresent(indices -> check(element, indices, findings));
    }
  }

  private static void check(DocumentElement element, DocumentAttribute indices, Findings findings) {
    for (DocumentElement child : element.children()) {
      DocumentAttribute points = child.attribute("point").orElse(null);
      if (child.name().equals("Coordinate") && points != null) {
        int count = ((float[]) points.value(FieldType.MFVec3f)).length / 3;
        for (int index : (int[]) indices.value(FieldType.MFInt32)) {
          if (index >= count) {
            findings.add(GeometryRules.INDEX_OUT_OF_RANGE, indices, indices.name(), index, count);
            return;
          }
        }
      }
    }
  }
}
