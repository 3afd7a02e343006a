// The records that vertices of objects read, bound as buffer textures: instances, their flags, materials.
#pragma once

#include "renderer/gl/buffer.h"
#include "renderer/gpu_stream.h"

namespace renderer {

class ObjectRecords {
public:
    ObjectRecords();
    void instances(const gl::Buffer& records, const gl::Buffer& flags);
    void instances(const GpuStream::Piece& records, const GpuStream::Piece& flags);
    void materials(const gl::Buffer& materials);
    void bind() const;

private:
    gl::BufferTexture m_instances, m_flags, m_materials;
};

} // namespace renderer
