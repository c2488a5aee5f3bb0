package org.selectiverenderer.runtime.render.draw;

import com.jogamp.opengl.GL3;
import java.nio.FloatBuffer;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.runtime.instance.Light;
import org.selectiverenderer.runtime.instance.LightInstance;
import org.selectiverenderer.runtime.instance.ShapeInstance;
import org.selectiverenderer.runtime.instance.Surface;
import org.selectiverenderer.runtime.instance.Texture;
import org.selectiverenderer.runtime.render.gpu.GpuMesh;
import org.selectiverenderer.runtime.render.gpu.GpuTexture;
import org.selectiverenderer.runtime.render.gpu.ShapePrograms;
import org.selectiverenderer.runtime.render.gpu.ShapeVariant;
import org.selectiverenderer.runtime.render.mesh.MeshPacker;
import org.selectiverenderer.runtime.render.mesh.PackedMesh;
import org.selectiverenderer.runtime.render.mesh.VertexLayout;
import org.selectiverenderer.runtime.render.occlude.Occluders;

/**
 * What is on the graphics card: batches of small shapes, other meshes and images once however many
 * shapes use them.
 */
final class GpuAssets {
  private static final float[] NO_TRANSFORM = {1, 0, 0, 0, 1, 0, 0, 0, 1};

  private final Map<Mesh, MeshPart> meshes = new IdentityHashMap<>();
  private final List<GpuMesh> merged = new ArrayList<>();
  private final Map<Texture, GpuTexture> textures = new HashMap<>();
  private final ShapePrograms programs = new ShapePrograms();
  private final Map<DrawList.State, Integer> ranks = new HashMap<>();
  private long uploads;

  /** Meshes and textures sent to the graphics card since the start. */
  long uploads() {
    return uploads;
  }

  /**
   * Uploads what new shapes draw: small ones of one look together in batches, the meshes of others
   * each by itself. All is packed on all processors.
   *
   * @return the parts of shapes in batches; others draw their own mesh
   */
  Map<ShapeInstance, MeshPart> prepare(GL3 gl, List<BatchPlan.Candidate> shapes) {
    Map<ShapeInstance, MeshPart> parts = new IdentityHashMap<>();
    BatchPlan.of(shapes).parallelStream()
        .map(PackedBatch::pack)
        .toList()
        .forEach(
            batch -> {
              GpuMesh gpu = new GpuMesh(gl, batch.merged().mesh());
              merged.add(gpu);
              uploads++;
              batch.parts(gpu, parts);
            });
    Set<Mesh> missing = Collections.newSetFromMap(new IdentityHashMap<>());
    for (BatchPlan.Candidate shape : shapes) {
      if (!parts.containsKey(shape.shape()) && !meshes.containsKey(shape.mesh())) {
        missing.add(shape.mesh());
      }
    }
    missing.parallelStream()
        .map(mesh -> Map.entry(mesh, MeshPacker.pack(mesh)))
        .toList()
        .forEach(packed -> upload(gl, packed.getKey(), packed.getValue()));
    return parts;
  }

  private MeshPart upload(GL3 gl, Mesh mesh, PackedMesh packed) {
    MeshPart whole = MeshPart.whole(new GpuMesh(gl, packed), Occluders.of(mesh));
    meshes.put(mesh, whole);
    uploads++;
    return whole;
  }

  /** What a shape draws that is in no batch: its mesh, uploaded unless it is there. */
  MeshPart part(GL3 gl, Mesh mesh) {
    MeshPart whole = meshes.get(mesh);
    return whole == null ? upload(gl, mesh, MeshPacker.pack(mesh)) : whole;
  }

  DrawItem item(ShapeInstance shape, Mesh mesh, DrawLook look, MeshPart part) {
    return new DrawItem(
        shape,
        mesh,
        shape.surface(),
        part,
        look.texture(),
        look.programs(),
        look.lights(),
        look.material().array(),
        look.textureTransform().array(),
        look.blended(),
        ranks.computeIfAbsent(
            new DrawList.State(look.programs(), look.texture()), state -> ranks.size()));
  }

  /** How a shape with that mesh is drawn; its texture is uploaded unless it is there. */
  DrawLook look(GL3 gl, ShapeInstance shape, Mesh mesh, List<LightInstance> scope) {
    Surface surface = shape.surface();
    GpuTexture texture =
        surface.texture() == null || mesh.texCoords() == null
            ? null
            : textures.computeIfAbsent(
                surface.texture(),
                image -> {
                  uploads++;
                  return new GpuTexture(gl, image);
                });
    boolean blended = blended(surface, mesh, texture);
    float[] transform = surface.textureTransform();
    return new DrawLook(
        programs.get(variant(mesh, surface, scope, texture, blended)),
        texture,
        scope,
        FloatBuffer.wrap(numbers(surface)),
        FloatBuffer.wrap(transform == null ? NO_TRANSFORM : transform),
        blended,
        VertexLayout.of(mesh),
        mesh.primitive(),
        mesh.solid());
  }

  private static boolean blended(Surface surface, Mesh mesh, @Nullable GpuTexture texture) {
    return surface.transparency() > 0
        || MeshPacker.translucent(mesh)
        || (texture != null && texture.alpha() == GpuTexture.Alpha.BLENDED);
  }

  private static ShapeVariant variant(
      Mesh mesh,
      Surface surface,
      List<LightInstance> scope,
      @Nullable GpuTexture texture,
      boolean blended) {
    boolean shiny =
        surface.specular()[0] > 0 || surface.specular()[1] > 0 || surface.specular()[2] > 0;
    Texture image = surface.texture();
    return new ShapeVariant(
        surface.lit() && mesh.normals() != null,
        shiny,
        has(scope, Light.Kind.POINT),
        has(scope, Light.Kind.SPOT),
        mesh.colors() != null,
        texture != null,
        image != null && image.image().components() <= 2,
        texture != null && texture.alpha() == GpuTexture.Alpha.CUT_OUT,
        !mesh.solid(),
        mesh.primitive() == Mesh.Primitive.POINTS,
        blended);
  }

  private static boolean has(List<LightInstance> scope, Light.Kind kind) {
    return scope.stream().anyMatch(light -> light.light().kind() == kind);
  }

  private static float[] numbers(Surface surface) {
    float[] d = surface.diffuse();
    float[] e = surface.emissive();
    float[] s = surface.specular();
    return new float[] {
      d[0],
      d[1],
      d[2],
      1 - surface.transparency(),
      e[0],
      e[1],
      e[2],
      surface.ambientIntensity(),
      s[0],
      s[1],
      s[2],
      surface.shininess() * 128
    };
  }

  /** Frees what none of the items uses. */
  void keepOnly(GL3 gl, List<DrawItem> items) {
    Set<GpuMesh> usedMeshes = new HashSet<>();
    Set<GpuTexture> usedTextures = new HashSet<>();
    for (DrawItem item : items) {
      usedMeshes.add(item.mesh());
      usedTextures.add(item.texture());
    }
    sweep(meshes, part -> usedMeshes.contains(part.mesh()), part -> part.mesh().dispose(gl));
    merged.removeIf(
        mesh -> {
          boolean unused = !usedMeshes.contains(mesh);
          if (unused) {
            mesh.dispose(gl);
          }
          return unused;
        });
    sweep(textures, usedTextures::contains, texture -> texture.dispose(gl));
    ranks.keySet().removeIf(s -> s.texture() != null && !usedTextures.contains(s.texture()));
  }

  private static <K, V> void sweep(Map<K, V> all, Predicate<V> used, Consumer<V> dispose) {
    for (Iterator<Map.Entry<K, V>> i = all.entrySet().iterator(); i.hasNext(); ) {
      Map.Entry<K, V> entry = i.next();
      if (!used.test(entry.getValue())) {
        dispose.accept(entry.getValue());
        i.remove();
      }
    }
  }

  void dispose(GL3 gl) {
    keepOnly(gl, List.of());
    programs.dispose(gl);
  }
}
