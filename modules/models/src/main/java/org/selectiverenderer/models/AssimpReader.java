package org.selectiverenderer.models;

import static org.lwjgl.assimp.Assimp.aiImportFile;
import static org.lwjgl.assimp.Assimp.aiPrimitiveType_TRIANGLE;
import static org.lwjgl.assimp.Assimp.aiProcess_JoinIdenticalVertices;
import static org.lwjgl.assimp.Assimp.aiProcess_PreTransformVertices;
import static org.lwjgl.assimp.Assimp.aiProcess_SortByPType;
import static org.lwjgl.assimp.Assimp.aiProcess_Triangulate;
import static org.lwjgl.assimp.Assimp.aiProcess_ValidateDataStructure;
import static org.lwjgl.assimp.Assimp.aiReleaseImport;

import java.io.IOException;
import java.nio.IntBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.lwjgl.assimp.AIColor4D;
import org.lwjgl.assimp.AIFace;
import org.lwjgl.assimp.AIMaterial;
import org.lwjgl.assimp.AIMesh;
import org.lwjgl.assimp.AIScene;
import org.lwjgl.assimp.AIVector3D;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.base.natives.LwjglLibraries;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.tessellate.MeshFactory;

/** Reads OBJ, PLY, STL and glTF files with Assimp. */
final class AssimpReader {
  private static final int STEPS =
      aiProcess_Triangulate
          | aiProcess_PreTransformVertices
          | aiProcess_SortByPType
          | aiProcess_JoinIdenticalVertices
          | aiProcess_ValidateDataStructure;

  /** The crease angle of files without normals, 45 degrees: flatter edges are shaded smooth. */
  private static final double CREASE_ANGLE = Math.PI / 4;

  private final NodeCatalogue catalogue;
  private final ProblemCollector problems;

  AssimpReader(NodeCatalogue catalogue, ProblemCollector problems) {
    this.catalogue = catalogue;
    this.problems = problems;
  }

  /**
   * @return empty if the file is damaged or not of the format that its name says, which is reported
   *     as a problem
   * @throws IOException if it cannot be read
   */
  Optional<Model> read(Path file) throws IOException {
    LwjglLibraries.use(AssimpReader.class, LwjglLibraries.Part.ASSIMP);
    AIScene scene = aiImportFile(file.toAbsolutePath().toString(), STEPS);
    if (scene == null) {
      new ModelFileDiagnostics(file, problems).report();
      return Optional.empty();
    }
    try {
      Model model = new Model(parts(scene, file), List.of());
      boolean damaged =
          model.polygons() == 0 && new ModelFileDiagnostics(file, problems).reportMissingFaces();
      return damaged ? Optional.empty() : Optional.of(model);
    } finally {
      aiReleaseImport(scene);
    }
  }

  private List<ModelPart> parts(AIScene scene, Path file) {
    // The normals in an STL file are facet normals, even where the surface is meant to be smooth.
    boolean facets = file.toString().toLowerCase(Locale.ROOT).endsWith(".stl");
    List<ModelPart> parts = new ArrayList<>();
    for (int i = 0; i < scene.mNumMeshes(); i++) {
      AIMesh mesh = AIMesh.create(scene.mMeshes().get(i));
      // Assimp sets a further flag for triangles that are parts of larger faces.
      if ((mesh.mPrimitiveTypes() & aiPrimitiveType_TRIANGLE) == 0) {
        continue;
      }
      NodeView appearance =
          new AssimpMaterialConverter(
                  AIMaterial.create(scene.mMaterials().get(mesh.mMaterialIndex())), catalogue)
              .appearance(file, problems);
      Mesh read = mesh(mesh, file, facets, TextureUsage.used(appearance));
      if (!read.isEmpty()) {
        parts.add(new ModelPart(appearance, read, ModelReader.folder(file)));
      }
    }
    return parts;
  }

  private Mesh mesh(AIMesh mesh, Path file, boolean facets, boolean textured) {
    float[] positions = vectors(mesh.mVertices(), 3);
    float[] normals = facets || mesh.mNormals() == null ? null : vectors(mesh.mNormals(), 3);
    float[] texCoords =
        textured && mesh.mTextureCoords(0) != null ? vectors(mesh.mTextureCoords(0), 2) : null;
    int[] triangles = finite(triangles(mesh), positions, mesh.mName().dataString(), file);
    if (normals != null && !units(normals)) {
      normals = null;
    }
    return MeshFactory.of(
        new TriangleMesh(clean(positions), triangles),
        normals,
        colors(mesh),
        texCoords,
        CREASE_ANGLE,
        true);
  }

  private static int[] triangles(AIMesh mesh) {
    int[] triangles = new int[3 * mesh.mNumFaces()];
    int count = 0;
    AIFace.Buffer faces = mesh.mFaces();
    for (int f = 0; f < mesh.mNumFaces(); f++) {
      IntBuffer indices = faces.get(f).mIndices();
      if (indices.remaining() == 3) { // Assimp keeps faces without corners.
        indices.get(triangles, count, 3);
        count += 3;
      }
    }
    return Arrays.copyOf(triangles, count);
  }

  private int[] finite(int[] triangles, float[] positions, String name, Path file) {
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
          SourceLocation.of(file.toString()),
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
   * Returns the values with non-finite ones replaced, which vertices that no triangle uses may
   * have.
   */
  private static float[] clean(float[] values) {
    for (int i = 0; i < values.length; i++) {
      values[i] = Float.isFinite(values[i]) ? values[i] : 0;
    }
    return values;
  }

  private static boolean units(float[] normals) {
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

  private static float[] vectors(AIVector3D.Buffer from, int components) {
    float[] values = new float[components * from.remaining()];
    for (int i = 0, at = 0; at < values.length; i++) {
      AIVector3D v = from.get(i);
      values[at++] = v.x();
      values[at++] = v.y();
      if (components == 3) {
        values[at++] = v.z();
      }
    }
    return components == 2 ? clean(values) : values;
  }

  private static float @Nullable [] colors(AIMesh mesh) {
    AIColor4D.Buffer from = mesh.mColors(0);
    if (from == null) {
      return null;
    }
    float[] colors = new float[4 * from.remaining()];
    for (int i = 0; i < from.remaining(); i++) {
      AIColor4D c = from.get(i);
      colors[4 * i] = unit(c.r());
      colors[4 * i + 1] = unit(c.g());
      colors[4 * i + 2] = unit(c.b());
      colors[4 * i + 3] = unit(c.a());
    }
    return colors;
  }

  private static float unit(float value) {
    return value >= 0 ? Math.min(value, 1) : 0;
  }
}
