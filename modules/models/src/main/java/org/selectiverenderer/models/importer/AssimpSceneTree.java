package org.selectiverenderer.models.importer;

import static org.lwjgl.assimp.Assimp.AI_FLOAT;
import static org.lwjgl.assimp.Assimp.aiLightSource_DIRECTIONAL;
import static org.lwjgl.assimp.Assimp.aiLightSource_POINT;
import static org.lwjgl.assimp.Assimp.aiLightSource_SPOT;

import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.lwjgl.PointerBuffer;
import org.lwjgl.assimp.AIAnimation;
import org.lwjgl.assimp.AIBone;
import org.lwjgl.assimp.AICamera;
import org.lwjgl.assimp.AIColor3D;
import org.lwjgl.assimp.AILight;
import org.lwjgl.assimp.AIMatrix4x4;
import org.lwjgl.assimp.AIMesh;
import org.lwjgl.assimp.AIMetaData;
import org.lwjgl.assimp.AIMetaDataEntry;
import org.lwjgl.assimp.AINode;
import org.lwjgl.assimp.AINodeAnim;
import org.lwjgl.assimp.AIQuatKey;
import org.lwjgl.assimp.AIScene;
import org.lwjgl.assimp.AIString;
import org.lwjgl.assimp.AITexture;
import org.lwjgl.assimp.AIVector3D;
import org.lwjgl.assimp.AIVectorKey;
import org.lwjgl.assimp.AIVertexWeight;
import org.lwjgl.system.MemoryUtil;
import org.selectiverenderer.models.importer.ImportedModel.LightKind;

/**
 * Writes what Assimp's scene has beside meshes and materials: textures, nodes, cameras, lights and
 * animations. Cameras, lights, joints and animations name their nodes.
 */
final class AssimpSceneTree {
  /** Characters of a name or url, beyond which it is cut. */
  private static final int LONGEST = 8192;

  /** Assimp's ticks of animations that tell none. */
  private static final double USUAL_TICKS = 25;

  /** The angle of a half circle that was converted from degrees to radians twice. */
  private static final double LEAST_ANGLE = Math.toRadians(Math.PI);

  /** How the names begin that Assimp gives to nodes of COLLADA without one. */
  private static final String AUTOMATIC = "$ColladaAutoName$";

  private final AIScene scene;
  private final List<String> names;
  private final boolean whole;
  private final ImportedModelEncoder out;
  private final List<AINode> nodes = new ArrayList<>();
  private final List<Integer> parents = new ArrayList<>();
  private final Map<String, Integer> byName = new HashMap<>();

  /**
   * @param names the names of the nodes, breadth first, by which nothing is found; empty where
   *     those of the scene itself are to be written
   * @param whole whether nodes and what they have are written
   */
  AssimpSceneTree(AIScene scene, List<String> names, boolean whole, ImportedModelEncoder out) {
    this.scene = scene;
    this.names = names;
    this.whole = whole;
    this.out = out;
    AINode root = scene.mRootNode();
    if (whole && root != null) {
      collect(root, -1);
    }
  }

  /** Lists the nodes, breadth first, so that no depth of the tree overflows the stack. */
  private void collect(AINode root, int parent) {
    nodes.add(root);
    parents.add(parent);
    for (int i = 0; i < nodes.size(); i++) {
      AINode node = nodes.get(i);
      byName.putIfAbsent(text(node.mName()), i);
      PointerBuffer children = node.mChildren();
      for (int k = 0; children != null && k < node.mNumChildren(); k++) {
        nodes.add(AINode.create(children.get(k)));
        parents.add(i);
      }
    }
  }

  /** Returns the names of the nodes of a scene, breadth first. */
  static List<String> names(AIScene scene) {
    AssimpSceneTree tree =
        new AssimpSceneTree(
            scene,
            List.of(),
            true,
            new ImportedModelEncoder(new DataOutputStream(OutputStream.nullOutputStream())));
    return tree.nodes.stream().map(node -> text(node.mName())).toList();
  }

  private String name(int node) {
    String own = text(nodes.get(node).mName());
    boolean named = names.size() == nodes.size() && !names.get(node).startsWith(AUTOMATIC);
    return named ? names.get(node) : own;
  }

  static String text(AIString text) {
    // Names of some formats are not in UTF-8.
    String all = StandardCharsets.UTF_8.decode(text.data()).toString();
    return all.substring(0, Math.min(all.length(), LONGEST));
  }

  /** Returns the index of the picture inside of the file that a url means; -1 if it means none. */
  static int embedded(AIScene scene, AIString url) {
    String wanted = text(url);
    PointerBuffer textures = scene.mTextures();
    if (textures == null || wanted.isEmpty()) {
      return -1;
    }
    if (wanted.startsWith("*")) {
      try {
        return Integer.parseInt(wanted.substring(1));
      } catch (NumberFormatException e) {
        return -1;
      }
    }
    for (int i = 0; i < scene.mNumTextures(); i++) {
      String name = text(AITexture.create(textures.get(i)).mFilename());
      if (!name.isEmpty() && last(name).equals(last(wanted))) {
        return i;
      }
    }
    return -1;
  }

  private static String last(String path) {
    return path.substring(Math.max(path.lastIndexOf('/'), path.lastIndexOf('\\')) + 1);
  }

  /**
   * Writes textures and nodes.
   *
   * @param meshes the index by which each of Assimp's meshes is written; -1 for none
   */
  void writeNodes(int[] meshes) throws IOException {
    PointerBuffer textures = scene.mTextures();
    out.number(textures == null ? 0 : scene.mNumTextures());
    for (int i = 0; textures != null && i < scene.mNumTextures(); i++) {
      AITexture texture = AITexture.create(textures.get(i));
      out.bytes(
          texture.mHeight() == 0 // else texels, which no format of today has
              ? MemoryUtil.memByteBuffer(texture.pcData().address0(), texture.mWidth())
              : null);
    }
    out.number(nodes.size());
    for (int i = 0; i < nodes.size(); i++) {
      AINode node = nodes.get(i);
      out.string(name(i));
      out.number(parents.get(i));
      out.floats(matrix(node.mTransformation()));
      List<Integer> shown = new ArrayList<>();
      for (int k = 0; node.mMeshes() != null && k < node.mNumMeshes(); k++) {
        int mesh = meshes[node.mMeshes().get(k)];
        if (mesh >= 0) {
          shown.add(mesh);
        }
      }
      out.ints(shown.size(), shown::get);
    }
  }

  private static float[] matrix(AIMatrix4x4 m) {
    return new float[] {
      m.a1(), m.b1(), m.c1(), m.d1(), m.a2(), m.b2(), m.c2(), m.d2(),
      m.a3(), m.b3(), m.c3(), m.d3(), m.a4(), m.b4(), m.c4(), m.d4()
    };
  }

  /** Writes the joints of a mesh that are nodes. */
  void writeBones(AIMesh mesh) throws IOException {
    List<AIBone> bones = new ArrayList<>();
    PointerBuffer all = mesh.mBones();
    for (int i = 0; whole && all != null && i < mesh.mNumBones(); i++) {
      AIBone bone = AIBone.create(all.get(i));
      if (byName.containsKey(text(bone.mName())) && bone.mWeights() != null) {
        bones.add(bone);
      }
    }
    out.number(bones.size());
    for (AIBone bone : bones) {
      AIVertexWeight.Buffer weights = bone.mWeights();
      float[] values = new float[weights.remaining()];
      for (int i = 0; i < values.length; i++) {
        values[i] = weights.get(i).mWeight();
      }
      out.number(byName.getOrDefault(text(bone.mName()), 0));
      out.floats(matrix(bone.mOffsetMatrix()));
      out.ints(values.length, i -> weights.get(i).mVertexId());
      out.floats(values);
    }
  }

  /** Writes cameras, lights and animations. */
  void writeViews() throws IOException {
    List<AICamera> cameras = new ArrayList<>();
    for (int i = 0; whole && i < scene.mNumCameras(); i++) {
      cameras.add(AICamera.create(scene.mCameras().get(i)));
    }
    cameras.removeIf(camera -> !byName.containsKey(text(camera.mName())));
    out.number(cameras.size());
    for (AICamera camera : cameras) {
      out.number(byName.getOrDefault(text(camera.mName()), 0));
      out.floats(vector(camera.mPosition()));
      out.floats(vector(camera.mLookAt()));
      out.floats(vector(camera.mUp()));
      out.number(fieldOfView(camera.mHorizontalFOV()));
      out.number(camera.mAspect());
      out.number(camera.mOrthographicWidth());
    }
    List<AILight> lights = new ArrayList<>();
    for (int i = 0; whole && i < scene.mNumLights(); i++) {
      lights.add(AILight.create(scene.mLights().get(i)));
    }
    lights.removeIf(light -> !byName.containsKey(text(light.mName())));
    out.number(lights.size());
    for (AILight light : lights) {
      write(light);
    }
    int animations = whole ? scene.mNumAnimations() : 0;
    out.number(animations);
    for (int i = 0; i < animations; i++) {
      write(AIAnimation.create(scene.mAnimations().get(i)));
    }
  }

  /**
   * Returns a horizontal angle in radians. Assimp 5.4 converts those of COLLADA from degrees twice,
   * which makes them less than any lens has.
   */
  private static float fieldOfView(float angle) {
    return angle < LEAST_ANGLE ? (float) Math.toDegrees(angle) : angle;
  }

  private static float[] vector(AIVector3D v) {
    return new float[] {v.x(), v.y(), v.z()};
  }

  private void write(AILight light) throws IOException {
    LightKind kind =
        switch (light.mType()) {
          case aiLightSource_DIRECTIONAL -> LightKind.DIRECTIONAL;
          case aiLightSource_POINT -> LightKind.POINT;
          case aiLightSource_SPOT -> LightKind.SPOT;
          default -> LightKind.OTHER;
        };
    AIColor3D color = light.mColorDiffuse();
    float metres = metres();
    out.number(byName.getOrDefault(text(light.mName()), 0));
    out.number(kind.ordinal());
    out.floats(vector(light.mPosition()));
    out.floats(vector(light.mDirection()));
    out.floats(color.r(), color.g(), color.b());
    out.floats(
        light.mAttenuationConstant(),
        light.mAttenuationLinear() / metres,
        light.mAttenuationQuadratic() / (metres * metres));
    out.floats(light.mAngleInnerCone(), light.mAngleOuterCone());
  }

  /**
   * Returns the length in metres of the unit in which lights fall off. Assimp multiplies all
   * lengths of FBX by it except this.
   */
  private float metres() {
    AIMetaData data = scene.mMetaData();
    for (int i = 0; data != null && i < data.mNumProperties(); i++) {
      AIMetaDataEntry value = data.mValues().get(i);
      if (text(data.mKeys().get(i)).equals("UnitScaleFactor") && value.mType() == AI_FLOAT) {
        float centimetres = value.mData(Float.BYTES).order(ByteOrder.nativeOrder()).getFloat(0);
        return centimetres > 0 && Float.isFinite(centimetres) ? centimetres / 100 : 1;
      }
    }
    return 1;
  }

  private void write(AIAnimation animation) throws IOException {
    double ticks = animation.mTicksPerSecond();
    double perSecond = ticks > 0 ? ticks : USUAL_TICKS;
    List<AINodeAnim> channels = new ArrayList<>();
    for (int i = 0; animation.mChannels() != null && i < animation.mNumChannels(); i++) {
      channels.add(AINodeAnim.create(animation.mChannels().get(i)));
    }
    channels.removeIf(channel -> !byName.containsKey(text(channel.mNodeName())));
    out.string(text(animation.mName()));
    out.number(channels.size());
    for (AINodeAnim channel : channels) {
      out.number(byName.getOrDefault(text(channel.mNodeName()), 0));
      vectors(channel.mPositionKeys(), perSecond);
      rotations(channel.mRotationKeys(), perSecond);
      vectors(channel.mScalingKeys(), perSecond);
    }
    out.truth(animation.mNumMorphMeshChannels() + animation.mNumMeshChannels() > 0);
  }

  private void vectors(AIVectorKey.@Nullable Buffer keys, double perSecond) throws IOException {
    int count = keys == null ? 0 : keys.remaining();
    float[] times = new float[count];
    float[] values = new float[3 * count];
    for (int i = 0; keys != null && i < count; i++) {
      times[i] = (float) (keys.get(i).mTime() / perSecond);
      System.arraycopy(vector(keys.get(i).mValue()), 0, values, 3 * i, 3);
    }
    out.floats(times);
    out.floats(values);
  }

  private void rotations(AIQuatKey.@Nullable Buffer keys, double perSecond) throws IOException {
    int count = keys == null ? 0 : keys.remaining();
    float[] times = new float[count];
    float[] values = new float[4 * count];
    for (int i = 0; keys != null && i < count; i++) {
      AIQuatKey key = keys.get(i);
      times[i] = (float) (key.mTime() / perSecond);
      values[4 * i] = key.mValue().x();
      values[4 * i + 1] = key.mValue().y();
      values[4 * i + 2] = key.mValue().z();
      values[4 * i + 3] = key.mValue().w();
    }
    out.floats(times);
    out.floats(values);
  }
}
