// SPDX-License-Identifier: GPL-2.0-or-later
// The GLSL extensions every shader asks for; included first (GL_GOOGLE_include_directive itself must stand in each shader).
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_control_flow_attributes : enable
#extension GL_KHR_shader_subgroup_basic : require
