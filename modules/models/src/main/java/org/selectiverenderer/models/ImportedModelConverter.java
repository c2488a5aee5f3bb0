package org.selectiverenderer.models;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.models.importer.ImportedModel;
import org.selectiverenderer.models.importer.ImportedModel.ImportedMesh;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.tessellate.MeshFactory;
import org.selectiverenderer.x3d.url.BaseUrl;

/** Makes a model of what was imported; faces that cannot be drawn are left out and reported. */
final class ImportedModelConverter {
  /** The crease angle of files without normals, 45 degrees: flatter edges are shaded smooth. */
  private static final double CREASE_ANGLE = Math.PI / 4;

  private final ModelSource file;
  private final NodeCatalogue catalogue;
  private final ProblemCollector problems;

  ImportedModelConverter(ModelSource file, NodeCatalogue catalogue, ProblemCollector problems) {
    this.file = file;
    this.catalogue = catalogue;
    this.problems = problems;
  }

  Model model(ImportedModel imported) {
    List<ModelPart> parts = new ArrayList<>();
    ImportedImages pictures = new ImportedImages(imported.textures());
    for (ImportedMesh mesh : imported.meshes()) {
      NodeView appearance =
          new ImportedMaterialConverter(
                  imported.materials().get(mesh.material()), pictures, catalogue)
              .appearance(file.name(), null, problems);
      Mesh read = mesh(mesh, TextureUsage.used(appearance));
      if (!read.isEmpty()) {
        parts.add(new ModelPart(appearance, read, folder()));
      }
    }
    return new Model(parts, List.of());
  }

  private Path folder() {
    return file.base() instanceof BaseUrl.Folder folder ? folder.path() : Path.of("");
  }

  /** Returns the faces of a mesh that can be drawn. */
  Mesh mesh(ImportedMesh mesh, boolean textured) {
    // The normals in an STL file are facet normals, even where the surface is meant to be smooth.
    boolean facets = file.ending().equals("stl");
    float[] positions = mesh.positions();
    int[] triangles = finite(mesh);
    float[] normals = facets ? null : mesh.normals();
    if (normals != null && !units(normals)) {
      normals = null;
    }
    return MeshFactory.of(
        new TriangleMesh(clean(positions), triangles),
        normals,
        isWithoutColors(mesh.colors()) ? null : colors(mesh.colors()),
        textured && mesh.texCoords() != null ? clean(mesh.texCoords()) : null,
        CREASE_ANGLE,
        true);
  }

  /** Returns the triangles whose coordinates are all finite, and reports others. */
  int[] finite(ImportedMesh mesh) {
    int[] triangles = mesh.triangles();
    float[] positions = mesh.positions();
    String name = mesh.name();
    int[] kept = new int[triangles.length];
    int count = 0;
    for (int i = 0; i < triangles.length; i += 3) {
      if (finite(positions, triangles[i])
          && finite(positions, triangles[i + 1])
          && finite(positions, triangles[i + 2])) {
        System.arraycopy(triangles, i, kept, count, 3);
        count += 3;
      }
    }
    if (count < triangles.length) {
      problems.warning(
          SourceLocation.of(file.name()),
          "%s has %s with a coordinate that is not a finite number; they are left out"
              .formatted(
                  name.isEmpty() ? "a mesh" : "mesh " + name,
                  Pluralizer.of((triangles.length - count) / 3, "face")));
    }
    return Arrays.copyOf(kept, count);
  }

  private static boolean finite(float[] positions, int vertex) {
    return Float.isFinite(positions[3 * vertex])
        && Float.isFinite(positions[3 * vertex + 1])
        && Float.isFinite(positions[3 * vertex + 2]);
  }

  /**
   * Returns a copy with non-finite values replaced, which vertices that no triangle uses may have.
   */
  static float[] clean(float[] values) {
    float[] clean = values.clone();
    for (int i = 0; i < clean.length; i++) {
      clean[i] = Float.isFinite(clean[i]) ? clean[i] : 0;
    }
    return clean;
  }

  /** Returns whether all normals are of length 1. */
  static boolean units(float[] normals) {
    for (int i = 0; i < normals.length; i += 3) {
      double square =
          normals[i] * (double) normals[i]
              + normals[i + 1] * (double) normals[i + 1]
              + normals[i + 2] * (double) normals[i + 2];
      if (!(Math.abs(square - 1) < 0.01)) {
        return false;
      }
    }
    return true;
  }

  /**
   * Returns whether a mesh of an OBJ file has no colours of its own: if only some vertices of the
   * file have colours, Assimp makes all others black.
   */
  private boolean isWithoutColors(float @Nullable [] colors) {
    if (colors == null || !file.ending().equals("obj")) {
      return false;
    }
    for (int i = 0; i < colors.length; i++) {
      if (colors[i] != 0 && i % 4 != 3) {
        return false;
      }
    }
    return true;
  }

  private static float @Nullable [] colors(float @Nullable [] from) {
    if (from == null) {
      return null;
    }
    float[] colors = new float[from.length];
    for (int i = 0; i < colors.length; i++) {
      colors[i] = from[i] >= 0 ? Math.min(from[i], 1) : 0;
    }
    return colors;
  }
}
