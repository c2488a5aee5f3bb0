package org.selectiverenderer.models.importer;

import static org.lwjgl.assimp.Assimp.AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES;
import static org.lwjgl.assimp.Assimp.AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS;
import static org.lwjgl.assimp.Assimp.AI_CONFIG_IMPORT_NO_SKELETON_MESHES;
import static org.lwjgl.assimp.Assimp.AI_MATKEY_COLOR_DIFFUSE;
import static org.lwjgl.assimp.Assimp.AI_MATKEY_COLOR_EMISSIVE;
import static org.lwjgl.assimp.Assimp.AI_MATKEY_COLOR_SPECULAR;
import static org.lwjgl.assimp.Assimp.AI_MATKEY_OPACITY;
import static org.lwjgl.assimp.Assimp.AI_MATKEY_SHININESS;
import static org.lwjgl.assimp.Assimp.aiCreatePropertyStore;
import static org.lwjgl.assimp.Assimp.aiGetMaterialColor;
import static org.lwjgl.assimp.Assimp.aiGetMaterialFloatArray;
import static org.lwjgl.assimp.Assimp.aiGetMaterialTexture;
import static org.lwjgl.assimp.Assimp.aiGetMaterialTextureCount;
import static org.lwjgl.assimp.Assimp.aiImportFileExWithProperties;
import static org.lwjgl.assimp.Assimp.aiPrimitiveType_POINT;
import static org.lwjgl.assimp.Assimp.aiPrimitiveType_TRIANGLE;
import static org.lwjgl.assimp.Assimp.aiProcess_GlobalScale;
import static org.lwjgl.assimp.Assimp.aiProcess_JoinIdenticalVertices;
import static org.lwjgl.assimp.Assimp.aiProcess_PreTransformVertices;
import static org.lwjgl.assimp.Assimp.aiProcess_SortByPType;
import static org.lwjgl.assimp.Assimp.aiProcess_Triangulate;
import static org.lwjgl.assimp.Assimp.aiProcess_ValidateDataStructure;
import static org.lwjgl.assimp.Assimp.aiReleaseImport;
import static org.lwjgl.assimp.Assimp.aiReleasePropertyStore;
import static org.lwjgl.assimp.Assimp.aiReturn_SUCCESS;
import static org.lwjgl.assimp.Assimp.aiSetImportPropertyInteger;
import static org.lwjgl.assimp.Assimp.aiTextureType_BASE_COLOR;
import static org.lwjgl.assimp.Assimp.aiTextureType_DIFFUSE;
import static org.lwjgl.assimp.Assimp.aiTextureType_NONE;

import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.lwjgl.assimp.AIColor4D;
import org.lwjgl.assimp.AIFace;
import org.lwjgl.assimp.AIMaterial;
import org.lwjgl.assimp.AIMesh;
import org.lwjgl.assimp.AIPropertyStore;
import org.lwjgl.assimp.AIScene;
import org.lwjgl.assimp.AIString;
import org.lwjgl.assimp.AIVector3D;
import org.lwjgl.assimp.Assimp;
import org.lwjgl.system.MemoryStack;
import org.lwjgl.system.MemoryUtil;
import org.selectiverenderer.base.natives.LwjglLibraries;
import org.selectiverenderer.models.importer.ImportedModel.ImportedMaterial;

/** Reads a model with Assimp and writes what it holds. Only the child process uses this class. */
final class AssimpImporter {
  private static final int STEPS =
      aiProcess_Triangulate
          | aiProcess_GlobalScale // FBX tells its unit, most often centimetres
          | aiProcess_SortByPType
          | aiProcess_JoinIdenticalVertices
          | aiProcess_ValidateDataStructure;

  private final ServedFileIo files;
  private final boolean whole;

  /**
   * @param files the model's files; closed by {@link #read}
   * @param whole whether nodes are kept, instead of all meshes in one frame
   */
  AssimpImporter(ServedFileIo files, boolean whole) {
    this.files = files;
    this.whole = whole;
  }

  /**
   * Loads the native library, while the parent process is busy with the model.
   *
   * @return why that is not possible; "" if it is loaded
   */
  static String load() {
    try {
      LwjglLibraries.use(AssimpImporter.class, LwjglLibraries.Part.ASSIMP);
      Assimp.getLibrary();
      return "";
    } catch (UncheckedIOException e) {
      return String.valueOf(e.getCause().getMessage());
    } catch (LinkageError | RuntimeException e) {
      return String.valueOf(e.getMessage());
    }
  }

  void read(String name, DataOutputStream out) throws IOException {
    AIScene scene;
    List<String> names;
    String lower = name.toLowerCase(Locale.ROOT);
    AIPropertyStore properties = aiCreatePropertyStore();
    try (files) {
      int steps = whole ? STEPS : STEPS | aiProcess_PreTransformVertices;
      // The nodes of FBX become one each, not one for each of the parts of their matrices.
      aiSetImportPropertyInteger(properties, AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, 0);
      // A scene of nodes without meshes gets no figure of bones.
      aiSetImportPropertyInteger(properties, AI_CONFIG_IMPORT_NO_SKELETON_MESHES, whole ? 1 : 0);
      scene = aiImportFileExWithProperties(name, steps, files.io(), properties);
      if (scene == null && lower.endsWith(".ply")) {
        // The checks of the steps refuse clouds of points.
        scene = aiImportFileExWithProperties(name, 0, files.io(), properties);
      }
      names = whole && lower.endsWith(".dae") ? names(name, properties) : List.of();
      files.check();
    } finally {
      aiReleasePropertyStore(properties);
    }
    if (scene == null) {
      out.writeByte(ImportProtocol.UNREADABLE);
      return;
    }
    out.writeByte(ImportProtocol.MODEL);
    write(scene, names, new ImportedModelEncoder(out));
    aiReleaseImport(scene);
  }

  /**
   * Returns the names of the nodes of a COLLADA file. They are read apart, since Assimp finds what
   * a camera, a key frame or a joint belongs to by the only name that a node has, and of several
   * nodes with one name would take the first.
   */
  private List<String> names(String name, AIPropertyStore properties) {
    aiSetImportPropertyInteger(properties, AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, 1);
    AIScene named = aiImportFileExWithProperties(name, 0, files.io(), properties);
    if (named == null) {
      return List.of();
    }
    List<String> names = AssimpSceneTree.names(named);
    aiReleaseImport(named);
    return names;
  }

  private void write(AIScene scene, List<String> names, ImportedModelEncoder out)
      throws IOException {
    boolean[] textured = new boolean[scene.mNumMaterials()];
    out.number(textured.length);
    for (int i = 0; i < textured.length; i++) {
      ImportedMaterial material = material(scene, AIMaterial.create(scene.mMaterials().get(i)));
      textured[i] = material.texture() != null;
      out.material(material);
    }
    int[] written = new int[scene.mNumMeshes()]; // meshes of lines are left out
    int count = 0;
    for (int i = 0; i < written.length; i++) {
      written[i] = isShown(mesh(scene, i)) ? count++ : -1;
    }
    AssimpSceneTree tree = new AssimpSceneTree(scene, names, whole, out);
    tree.writeNodes(written);
    out.number(count);
    for (int i = 0; i < written.length; i++) {
      AIMesh mesh = mesh(scene, i);
      if (written[i] >= 0) {
        write(mesh, textured[mesh.mMaterialIndex()], out);
        tree.writeBones(mesh);
      }
    }
    tree.writeViews();
  }

  private static AIMesh mesh(AIScene scene, int index) {
    return AIMesh.create(scene.mMeshes().get(index));
  }

  private boolean isShown(AIMesh mesh) {
    // Assimp sets a further flag for triangles that are parts of larger faces.
    int types = mesh.mPrimitiveTypes();
    return (types & aiPrimitiveType_TRIANGLE) != 0 || whole && (types & aiPrimitiveType_POINT) != 0;
  }

  private static void write(AIMesh mesh, boolean textured, ImportedModelEncoder out)
      throws IOException {
    out.string(AssimpSceneTree.text(mesh.mName()));
    out.number(mesh.mMaterialIndex());
    out.floats(vectors(mesh.mVertices()), 3, 3);
    out.floats(vectors(mesh.mNormals()), 3, 3);
    out.floats(textured ? vectors(mesh.mTextureCoords(0)) : null, 3, 2);
    AIColor4D.Buffer colors = mesh.mColors(0);
    out.floats(
        colors == null
            ? null
            : MemoryUtil.memFloatBuffer(colors.address0(), 4 * colors.remaining()),
        4,
        4);
    IntBuffer triangles = triangles(mesh);
    try {
      out.ints(triangles.limit(), triangles::get);
    } finally {
      MemoryUtil.memFree(triangles);
    }
  }

  private static @Nullable FloatBuffer vectors(AIVector3D.@Nullable Buffer vectors) {
    return vectors == null
        ? null
        : MemoryUtil.memFloatBuffer(vectors.address0(), 3 * vectors.remaining());
  }

  private static IntBuffer triangles(AIMesh mesh) {
    IntBuffer triangles = MemoryUtil.memAllocInt(3 * mesh.mNumFaces());
    // A cloud of points has no faces, for which LWJGL has no buffer.
    AIFace.Buffer faces = mesh.mNumFaces() == 0 ? null : mesh.mFaces();
    for (int f = 0; faces != null && f < mesh.mNumFaces(); f++) {
      IntBuffer indices = faces.get(f).mIndices();
      if (indices.remaining() == 3) { // Assimp keeps faces without corners.
        triangles.put(indices);
      }
    }
    return triangles.flip();
  }

  private static ImportedMaterial material(AIScene scene, AIMaterial material) {
    return new ImportedMaterial(
        color(material, AI_MATKEY_COLOR_DIFFUSE),
        color(material, AI_MATKEY_COLOR_SPECULAR),
        color(material, AI_MATKEY_COLOR_EMISSIVE),
        number(material, AI_MATKEY_SHININESS),
        number(material, AI_MATKEY_OPACITY),
        texture(scene, material));
  }

  private static float @Nullable [] color(AIMaterial material, String key) {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      AIColor4D color = AIColor4D.calloc(stack);
      return aiGetMaterialColor(material, key, aiTextureType_NONE, 0, color) == aiReturn_SUCCESS
          ? new float[] {color.r(), color.g(), color.b()}
          : null;
    }
  }

  private static @Nullable Float number(AIMaterial material, String key) {
    float[] value = {0};
    int[] count = {1};
    return aiGetMaterialFloatArray(material, key, aiTextureType_NONE, 0, value, count)
            == aiReturn_SUCCESS
        ? value[0]
        : null;
  }

  private static @Nullable String texture(AIScene scene, AIMaterial material) {
    for (int kind : new int[] {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
      if (aiGetMaterialTextureCount(material, kind) > 0) {
        try (MemoryStack stack = MemoryStack.stackPush()) {
          AIString path = AIString.calloc(stack);
          int result =
              aiGetMaterialTexture(
                  material, kind, 0, path, (IntBuffer) null, null, null, null, null, null);
          if (result == aiReturn_SUCCESS) {
            int inside = AssimpSceneTree.embedded(scene, path);
            return inside < 0 ? AssimpSceneTree.text(path) : "*" + inside;
          }
        }
      }
    }
    return null;
  }
}
