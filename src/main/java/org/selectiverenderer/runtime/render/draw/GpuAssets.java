package org.selectiverenderer.runtime.render.draw;

import com.jogamp.opengl.GL3;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiConsumer;
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

/** What is on the graphics card, once per mesh and image however many shapes use it. */
final class GpuAssets {
  private static final float[] NO_TRANSFORM = {1, 0, 0, 0, 1, 0, 0, 0, 1};

  private final Map<Mesh, GpuMesh> meshes = new IdentityHashMap<>();
  private final Map<Texture, GpuTexture> textures = new HashMap<>();
  private final ShapePrograms programs = new ShapePrograms();
  private final Map<DrawList.State, Integer> ranks = new HashMap<>();
  private long uploads;

  /** Meshes and textures sent to the graphics card since the start. */
  long uploads() {
    return uploads;
  }

  /** Uploads the meshes of shapes; those that are new are packed on all processors. */
  void prepare(GL3 gl, List<ShapeInstance> shapes) {
    Set<Mesh> missing = Collections.newSetFromMap(new IdentityHashMap<>());
    for (ShapeInstance shape : shapes) {
      shape
          .mesh()
          .filter(mesh -> !mesh.isEmpty() && !meshes.containsKey(mesh))
          .ifPresent(missing::add);
    }
    missing.parallelStream()
        .map(mesh -> Map.entry(mesh, MeshPacker.pack(mesh)))
        .toList()
        .forEach(packed -> upload(gl, packed.getKey(), packed.getValue()));
  }

  private GpuMesh upload(GL3 gl, Mesh mesh, PackedMesh packed) {
    GpuMesh gpu = new GpuMesh(gl, packed);
    meshes.put(mesh, gpu);
    uploads++;
    return gpu;
  }

  DrawItem item(GL3 gl, ShapeInstance shape, Mesh mesh, List<LightInstance> scope) {
    GpuMesh gpu = meshes.get(mesh);
    if (gpu == null) {
      gpu = upload(gl, mesh, MeshPacker.pack(mesh));
    }
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
    boolean blended = blended(surface, gpu, texture);
    ShapePrograms.Family family = programs.get(variant(mesh, surface, scope, texture, blended));
    float[] transform = surface.textureTransform();
    return new DrawItem(
        shape,
        mesh,
        surface,
        gpu,
        texture,
        family,
        scope,
        numbers(surface),
        transform == null ? NO_TRANSFORM : transform,
        blended,
        ranks.computeIfAbsent(new DrawList.State(family, texture), state -> ranks.size()));
  }

  private static boolean blended(Surface surface, GpuMesh mesh, @Nullable GpuTexture texture) {
    return surface.transparency() > 0
        || mesh.translucentColors()
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
    sweep(meshes, usedMeshes, (mesh, unused) -> mesh.dispose(gl));
    sweep(textures, usedTextures, (texture, unused) -> texture.dispose(gl));
    ranks.keySet().removeIf(s -> s.texture() != null && !usedTextures.contains(s.texture()));
  }

  private static <K, V> void sweep(Map<K, V> all, Set<V> used, BiConsumer<V, K> dispose) {
    for (Iterator<Map.Entry<K, V>> i = all.entrySet().iterator(); i.hasNext(); ) {
      Map.Entry<K, V> entry = i.next();
      if (!used.contains(entry.getValue())) {
        dispose.accept(entry.getValue(), entry.getKey());
        i.remove();
      }
    }
  }

  void dispose(GL3 gl) {
    keepOnly(gl, List.of());
    programs.dispose(gl);
  }
}
