package org.selectiverenderer.lsl;

import static org.selectiverenderer.lsl.NativeFunction.Type.DOUBLE;
import static org.selectiverenderer.lsl.NativeFunction.Type.INT;
import static org.selectiverenderer.lsl.NativeFunction.Type.POINTER;
import static org.selectiverenderer.lsl.NativeFunction.Type.VOID;

import java.io.IOException;
import org.lwjgl.system.MemoryStack;
import org.lwjgl.system.MemoryUtil;
import org.lwjgl.system.SharedLibrary;

/** Bindings of the functions of {@code lsl_c.h} that this package calls. */
final class LslBindings {
  final NativeFunction version;
  final NativeFunction clock;
  final NativeFunction createInfo;
  final NativeFunction destroyInfo;
  final NativeFunction description;
  final NativeFunction appendChild;
  final NativeFunction appendValue;
  final NativeFunction createOutlet;
  final NativeFunction destroyOutlet;
  final NativeFunction pushDoubles;
  final NativeFunction pushTexts;
  final NativeFunction createResolver;
  final NativeFunction results;
  final NativeFunction destroyResolver;
  final NativeFunction name;
  final NativeFunction type;
  final NativeFunction host;
  final NativeFunction uid;
  final NativeFunction sourceId;
  final NativeFunction channels;
  final NativeFunction rate;
  final NativeFunction format;
  final NativeFunction createInlet;
  final NativeFunction destroyInlet;
  final NativeFunction fullInfo;
  final NativeFunction correction;
  final NativeFunction pullDoubles;
  final NativeFunction pullTexts;
  final NativeFunction destroyText;
  final NativeFunction child;
  final NativeFunction nextSibling;
  final NativeFunction childValue;

  /**
   * Looks up all functions.
   *
   * @throws IOException if a function is missing, as in another library
   */
  LslBindings(SharedLibrary from) throws IOException {
    version = NativeFunction.of(from, "lsl_library_version", INT);
    clock = NativeFunction.of(from, "lsl_local_clock", DOUBLE);
    createInfo =
        NativeFunction.of(
            from, "lsl_create_streaminfo", POINTER, POINTER, POINTER, INT, DOUBLE, INT, POINTER);
    destroyInfo = NativeFunction.of(from, "lsl_destroy_streaminfo", VOID, POINTER);
    description = NativeFunction.of(from, "lsl_get_desc", POINTER, POINTER);
    appendChild = NativeFunction.of(from, "lsl_append_child", POINTER, POINTER, POINTER);
    appendValue =
        NativeFunction.of(from, "lsl_append_child_value", POINTER, POINTER, POINTER, POINTER);
    createOutlet = NativeFunction.of(from, "lsl_create_outlet", POINTER, POINTER, INT, INT);
    destroyOutlet = NativeFunction.of(from, "lsl_destroy_outlet", VOID, POINTER);
    pushDoubles = NativeFunction.of(from, "lsl_push_sample_dt", INT, POINTER, POINTER, DOUBLE);
    pushTexts = NativeFunction.of(from, "lsl_push_sample_strt", INT, POINTER, POINTER, DOUBLE);
    createResolver =
        NativeFunction.of(from, "lsl_create_continuous_resolver_bypred", POINTER, POINTER, DOUBLE);
    results = NativeFunction.of(from, "lsl_resolver_results", INT, POINTER, POINTER, INT);
    destroyResolver = NativeFunction.of(from, "lsl_destroy_continuous_resolver", VOID, POINTER);
    name = NativeFunction.of(from, "lsl_get_name", POINTER, POINTER);
    type = NativeFunction.of(from, "lsl_get_type", POINTER, POINTER);
    host = NativeFunction.of(from, "lsl_get_hostname", POINTER, POINTER);
    uid = NativeFunction.of(from, "lsl_get_uid", POINTER, POINTER);
    sourceId = NativeFunction.of(from, "lsl_get_source_id", POINTER, POINTER);
    channels = NativeFunction.of(from, "lsl_get_channel_count", INT, POINTER);
    rate = NativeFunction.of(from, "lsl_get_nominal_srate", DOUBLE, POINTER);
    format = NativeFunction.of(from, "lsl_get_channel_format", INT, POINTER);
    createInlet = NativeFunction.of(from, "lsl_create_inlet", POINTER, POINTER, INT, INT, INT);
    destroyInlet = NativeFunction.of(from, "lsl_destroy_inlet", VOID, POINTER);
    fullInfo = NativeFunction.of(from, "lsl_get_fullinfo", POINTER, POINTER, DOUBLE, POINTER);
    correction =
        NativeFunction.of(
            from, "lsl_time_correction_ex", DOUBLE, POINTER, POINTER, POINTER, DOUBLE, POINTER);
    pullDoubles =
        NativeFunction.of(
            from, "lsl_pull_sample_d", DOUBLE, POINTER, POINTER, INT, DOUBLE, POINTER);
    pullTexts =
        NativeFunction.of(
            from, "lsl_pull_sample_str", DOUBLE, POINTER, POINTER, INT, DOUBLE, POINTER);
    destroyText = NativeFunction.of(from, "lsl_destroy_string", VOID, POINTER);
    child = NativeFunction.of(from, "lsl_child", POINTER, POINTER, POINTER);
    nextSibling = NativeFunction.of(from, "lsl_next_sibling_n", POINTER, POINTER, POINTER);
    childValue = NativeFunction.of(from, "lsl_child_value_n", POINTER, POINTER, POINTER);
  }

  /** Returns the address of a C string that lives as long as the stack frame. */
  static long text(MemoryStack stack, String text) {
    return MemoryUtil.memAddress(stack.UTF8(text));
  }

  /** Returns the text of a C string; empty for NULL. */
  static String text(long address) {
    return address == MemoryUtil.NULL ? "" : MemoryUtil.memUTF8(address);
  }
}
